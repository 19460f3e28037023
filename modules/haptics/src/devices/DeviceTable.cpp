#include <insonate/core/JsonEntry.h>
#include <insonate/embedded/haptic_devices.h>
#include <insonate/haptics/DeviceTable.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>

namespace insonate {
namespace {

using Json = nlohmann::json;

/// In the order of Quantity and DeviceKind.
constexpr std::array<std::string_view, 12> kQuantities{"encoder", "position", "quaternion", "deflection",
                                                       "buttons", "key",      "status",     "sequence",
                                                       "time",    "force",    "torque",     "current"};
constexpr std::array<std::string_view, 6> kDeviceKinds{"force", "motion", "pedal", "camera", "tracker", "controller"};
/// Number of kinds, from the first one, that a table can describe.
constexpr int kTableKinds = 3;

/// Number of indices of a quantity.
int indicesOf(Quantity quantity) {
  switch (quantity) {
    case Quantity::kEncoder:
    case Quantity::kDeflection:
      return 6;
    case Quantity::kQuaternion:
      return 4;
    case Quantity::kButtons:
    case Quantity::kKey:
      return 32;
    case Quantity::kStatus:
    case Quantity::kSequence:
    case Quantity::kTime:
      return 1;
    default:
      return 3;
  }
}

/// Four hexadecimal digits, as USB ids are written.
std::uint16_t idIn(JsonEntry& entry, std::string_view key) {
  const std::string digits = entry.text(key);
  unsigned value = 0;
  const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (digits.size() != 4 || code != std::errc() || end != digits.data() + 4)
    entry.setError("needs four hexadecimal digits as '" + std::string(key) + "', not '" + digits + "'.");
  return static_cast<std::uint16_t>(value);
}

std::optional<std::uint16_t> idIfThere(JsonEntry& entry, std::string_view key) {
  return entry.has(key) ? std::optional(idIn(entry, key)) : std::nullopt;
}

std::array<double, 3> threeIn(JsonEntry& entry, std::string_view key, double low, double high) {
  const auto three = entry.numbers(key, 3, low, high);
  return {three[0], three[1], three[2]};
}

Vec3 vectorIn(JsonEntry& entry, std::string_view key, double low, double high) {
  const auto three = entry.numbers(key, 3, low, high, "[x, y, z]");
  return {three[0], three[1], three[2]};
}

ReportField readField(const Json& json, const std::string& where, const ReportLayout& report, std::string& error) {
  JsonEntry entry(json, where,
                  {"quantity", "index", "bit", "bits", "signed", "wraps", "scale", "count", "usage", "unit"}, error);
  ReportField field;
  field.quantity = static_cast<Quantity>(entry.word("quantity", {kQuantities.begin(), kQuantities.end()}));
  field.index = entry.optionalInteger("index", 0, indicesOf(field.quantity) - 1).value_or(0);
  field.bit = entry.integer("bit", 0, 8 * 255);
  field.bits = entry.integer("bits", 1, 32);
  field.isSigned = entry.flag("signed");
  field.wraps = entry.flag("wraps");
  field.scale = entry.optionalNumber("scale", -1e6, 1e6).value_or(1);
  field.count = entry.optionalInteger("count", 1, 64).value_or(1);
  field.usage = entry.optionalInteger("usage", 0, 255).value_or(0);
  entry.text("unit", false);
  if (field.wraps && field.quantity != Quantity::kEncoder) entry.setError("has 'wraps', but is not an encoder.");
  if (field.scale == 0) entry.setError("has scale 0.");
  if (field.bit + field.bits * field.count > report.bytes * 8) entry.setError("reaches beyond its report.");
  if (field.quantity == Quantity::kButtons && field.index + field.bits > 32)
    entry.setError("has more than 32 buttons.");
  return field;
}

ReportLayout readLayout(const Json& json, const std::string& where, std::string& error) {
  JsonEntry entry(json, where, {"report", "bytes", "exact", "fields"}, error);
  ReportLayout report;
  report.id = entry.integer("report", 0, 255);
  report.bytes = entry.integer("bytes", 1, 63);
  report.exact = entry.flag("exact");
  report.fields = entry.list("fields", where + ", field", [&](const Json& field, const auto& at, auto& wrong) {
    return readField(field, at, report, wrong);
  });
  if (report.fields.empty()) entry.setError("has no list of 'fields'.");
  return report;
}

ArmTable readArm(const Json& json, std::string& error) {
  JsonEntry entry(json, "The arm",
                  {"length_mm", "counts_per_turn", "body_turns_per_motor_turn", "torque_Nmm_per_mA", "home_angle_deg",
                   "centre_mm", "most_current_mA"},
                  error);
  ArmTable arm;
  arm.length_mm = threeIn(entry, "length_mm", 1, 2000);
  arm.countsPerTurn = threeIn(entry, "counts_per_turn", 1, 1e6);
  arm.bodyTurnsPerMotorTurn = threeIn(entry, "body_turns_per_motor_turn", -10, 10);
  arm.torque_NmmPermA = threeIn(entry, "torque_Nmm_per_mA", 1e-6, 10);
  arm.homeAngle_deg = threeIn(entry, "home_angle_deg", -360, 360);
  arm.center_mm = vectorIn(entry, "centre_mm", -2000, 2000);
  arm.maxCurrent_mA = entry.number("most_current_mA", 1, 32767);
  for (const double turns : arm.bodyTurnsPerMotorTurn)
    if (turns == 0) entry.setError("has a 0 in 'body_turns_per_motor_turn'.");
  return arm;
}

DeviceLimits readLimits(const Json& json, std::string& error) {
  JsonEntry entry(json, "The entry 'limits'",
                  {"sensed_axes", "force_axes", "workspace_mm", "max_force_N", "continuous_force_N", "max_torque_Nmm",
                   "max_stiffness_Npmm", "rate_Hz", "resolution_mm", "damping_Nspm", "friction_N", "mass_kg"},
                  error);
  const auto zeroOr = [&](const char* key, double most) { return entry.optionalNumber(key, 0, most).value_or(0); };
  DeviceLimits limits;
  limits.sensedAxes = entry.integer("sensed_axes", 0, 6);
  limits.forceAxes = entry.integer("force_axes", 0, 6);
  limits.workspace_mm = vectorIn(entry, "workspace_mm", 0, 5000);
  limits.maxForce_N = zeroOr("max_force_N", 100);
  limits.continuousForce_N = zeroOr("continuous_force_N", 100);
  limits.maxTorque_Nmm = zeroOr("max_torque_Nmm", 10000);
  limits.maxStiffness_Npmm = zeroOr("max_stiffness_Npmm", 100);
  limits.rate_Hz = entry.number("rate_Hz", 1, 10000);
  limits.resolution_mm = zeroOr("resolution_mm", 10);
  limits.damping_Nspm = zeroOr("damping_Nspm", 1000);
  limits.friction_N = zeroOr("friction_N", 100);
  limits.mass_kg = zeroOr("mass_kg", 100);
  for (const int axes : {limits.sensedAxes, limits.forceAxes})
    if (axes != 0 && axes != 3 && axes != 6)
      entry.setError("states " + std::to_string(axes) + " axes; there are 0, 3 or 6.");
  if (limits.continuousForce_N > limits.maxForce_N)
    entry.setError("has a 'continuous_force_N' above its 'max_force_N'.");
  return limits;
}

DeviceMatch readMatch(const Json& json, const std::string& where, std::string& error) {
  JsonEntry entry(json, where, {"vendor", "product", "usage_page", "usage", "name"}, error);
  DeviceMatch match;
  match.vendor = idIn(entry, "vendor");
  match.product = idIn(entry, "product");
  match.usagePage = idIfThere(entry, "usage_page");
  match.usage = idIfThere(entry, "usage");
  match.name = entry.text("name", false);
  return match;
}

bool needsArm(const ReportLayout& report) {
  return std::any_of(report.fields.begin(), report.fields.end(),
                     [](const ReportField& f) { return f.quantity == Quantity::kCurrent; });
}

DeviceTable readTable(const Json& json, std::string& error) {
  JsonEntry entry(json, "The device table",
                  {"version", "name", "kind", "source", "match", "input", "output", "arm", "limits"}, error);
  DeviceTable table;
  entry.integer("version", 1, 1);
  table.name = entry.text("name");
  table.kind = static_cast<DeviceKind>(entry.word("kind", {kDeviceKinds.begin(), kDeviceKinds.begin() + kTableKinds}));
  table.source = entry.text("source");
  table.matches = entry.list("match", "match", readMatch, false);
  if (table.matches.empty()) entry.setError("matches no device; list at least one under 'match'.");
  table.input = entry.list("input", "input report", readLayout);
  if (table.input.empty()) entry.setError("has no list of input reports, 'input'.");
  if (entry.has("output")) table.output = readLayout(entry.value("output"), "the output report", error);
  if (entry.has("arm")) table.arm = readArm(entry.value("arm"), error);
  table.limits = readLimits(entry.value("limits"), error);
  if (table.kind == DeviceKind::kForce && !table.output) entry.setError("is of a force device, but has no 'output'.");
  if (table.kind == DeviceKind::kForce && table.limits.maxForce_N <= 0) entry.setError("is of a force device of 0 N.");
  if (table.output && needsArm(*table.output) && !table.arm) entry.setError("sends currents, but has no 'arm'.");
  return table;
}

}  // namespace

std::string_view nameOf(DeviceKind kind) {
  return kDeviceKinds[static_cast<std::size_t>(kind)];
}

Result<DeviceTable> parseDeviceTable(std::string_view text) {
  const auto json = parsedJson(text, "The device table");
  if (!json) return tl::unexpected(json.error());
  std::string error;
  DeviceTable table = readTable(*json, error);
  if (!error.empty()) return fail(std::move(error));
  return table;
}

const std::vector<DeviceTable>& builtInDeviceTables() {
  static const std::vector<DeviceTable> all = [] {
    std::vector<DeviceTable> tables;
    for (const auto& file : embedded::haptic_devices::files())
      if (auto table = parseDeviceTable(file.text)) tables.push_back(std::move(*table));
    return tables;
  }();
  return all;
}

}  // namespace insonate
