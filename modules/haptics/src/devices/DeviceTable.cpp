#include <insonate/core/Words.h>
#include <insonate/embedded/haptic_devices.h>
#include <insonate/haptics/DeviceTable.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace insonate {
namespace {

using Json = nlohmann::json;

constexpr std::array<std::pair<std::string_view, Quantity>, 12> kQuantities{{{"encoder", Quantity::kEncoder},
                                                                             {"position", Quantity::kPosition},
                                                                             {"quaternion", Quantity::kQuaternion},
                                                                             {"deflection", Quantity::kDeflection},
                                                                             {"buttons", Quantity::kButtons},
                                                                             {"key", Quantity::kKey},
                                                                             {"status", Quantity::kStatus},
                                                                             {"sequence", Quantity::kSequence},
                                                                             {"time", Quantity::kTime},
                                                                             {"force", Quantity::kForce},
                                                                             {"torque", Quantity::kTorque},
                                                                             {"current", Quantity::kCurrent}}};

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

/// One JSON object, read field by field. The first error is kept as a sentence; reading continues with zeros.
class Fields {
 public:
  Fields(const Json& object, std::string where, std::string& trouble)
      : object_(object), where_(std::move(where)), trouble_(trouble) {
    if (!object_.is_object()) refuse("is not an object");
  }
  /// Called after all fields are read: there must be no others.
  ~Fields() {
    if (!object_.is_object() || !trouble_.empty()) return;
    for (const auto& [name, value] : object_.items())
      if (std::find(known_.begin(), known_.end(), name) == known_.end()) {
        const auto near = nearestWord(name, known_);
        refuse("has no field '" + name + "'" + (near.empty() ? "" : "; did you mean '" + std::string(near) + "'?"));
        return;
      }
  }
  Fields(const Fields&) = delete;
  Fields& operator=(const Fields&) = delete;

  bool has(std::string_view name) {
    known_.push_back(name);
    return object_.is_object() && object_.contains(name);
  }
  const Json& at(std::string_view name) {
    static const Json kNone;
    if (has(name)) return object_.at(std::string(name));
    if (object_.is_object()) refuse("lacks '" + std::string(name) + "'");
    return kNone;
  }
  double number(std::string_view name, double least, double most) {
    return checked(at(name), std::string(name), least, most);
  }
  double number(std::string_view name, double least, double most, double otherwise) {
    return has(name) ? number(name, least, most) : otherwise;
  }
  int whole(std::string_view name, int least, int most) {
    const double value = number(name, least, most);
    if (value != std::floor(value)) refuse("'" + std::string(name) + "' is not a whole number");
    return static_cast<int>(value);
  }
  int whole(std::string_view name, int least, int most, int otherwise) {
    return has(name) ? whole(name, least, most) : otherwise;
  }
  bool flag(std::string_view name) {
    if (!has(name)) return false;
    const Json& value = object_.at(std::string(name));
    if (!value.is_boolean()) refuse("'" + std::string(name) + "' is neither true nor false");
    return value.is_boolean() && value.get<bool>();
  }
  std::string text(std::string_view name) {
    const Json& value = at(name);
    if (value.is_string() && !value.get_ref<const std::string&>().empty()) return value.get<std::string>();
    refuse("'" + std::string(name) + "' is not a text");
    return {};
  }
  std::array<double, 3> three(std::string_view name, double least, double most) {
    const Json& value = at(name);
    if (!value.is_array() || value.size() != 3) {
      refuse("'" + std::string(name) + "' is not a list of three numbers");
      return {};
    }
    std::array<double, 3> result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = checked(value[i], std::string(name), least, most);
    return result;
  }
  /// Four hexadecimal digits, as USB ids are written.
  std::uint16_t id(std::string_view name) {
    const std::string digits = text(name);
    unsigned value = 0;
    const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    if (digits.size() != 4 || code != std::errc() || end != digits.data() + 4)
      refuse("'" + std::string(name) + "' is not four hexadecimal digits");
    return static_cast<std::uint16_t>(value);
  }
  std::optional<std::uint16_t> optionalId(std::string_view name) {
    return has(name) ? std::optional(id(name)) : std::nullopt;
  }
  void refuse(const std::string& why) {
    if (trouble_.empty()) trouble_ = where_ + " " + why + ".";
  }

 private:
  double checked(const Json& value, const std::string& name, double least, double most) {
    if (!value.is_number()) {
      refuse("'" + name + "' is not a number");
      return least;
    }
    const double number = value.get<double>();
    if (number >= least && number <= most) return number;
    char range[80];
    std::snprintf(range, sizeof range, "' is %g; it can be %g to %g", number, least, most);
    refuse("'" + name + range);
    return least;
  }

  const Json& object_;
  std::string where_;
  std::string& trouble_;
  std::vector<std::string_view> known_;
};

ReportField readField(const Json& json, const std::string& where, const ReportLayout& report, std::string& trouble) {
  ReportField field;
  Fields fields(json, where, trouble);
  const std::string name = fields.text("quantity");
  const auto* known = std::find_if(kQuantities.begin(), kQuantities.end(), [&](auto& q) { return q.first == name; });
  if (known == kQuantities.end()) {
    fields.refuse("speaks of '" + name + "', which no report carries");
    return field;
  }
  field.quantity = known->second;
  field.index = fields.whole("index", 0, indicesOf(field.quantity) - 1, 0);
  field.bit = fields.whole("bit", 0, 8 * 255);
  field.bits = fields.whole("bits", 1, 32);
  field.isSigned = fields.flag("signed");
  field.wraps = fields.flag("wraps");
  field.scale = fields.number("scale", -1e6, 1e6, 1);
  field.count = fields.whole("count", 1, 64, 1);
  field.usage = fields.whole("usage", 0, 255, 0);
  if (fields.has("unit")) fields.text("unit");
  if (field.wraps && field.quantity != Quantity::kEncoder) fields.refuse("wraps, but is no encoder");
  if (field.scale == 0) fields.refuse("has scale 0");
  if (field.bit + field.bits * field.count > report.bytes * 8) fields.refuse("reaches beyond its report");
  if (field.quantity == Quantity::kButtons && field.index + field.bits > 32) fields.refuse("has more than 32 buttons");
  return field;
}

ReportLayout readLayout(const Json& json, const std::string& where, std::string& trouble) {
  ReportLayout report;
  Fields fields(json, where, trouble);
  report.id = fields.whole("report", 0, 255);
  report.bytes = fields.whole("bytes", 1, 63);
  report.exact = fields.flag("exact");
  const Json& list = fields.at("fields");
  if (!list.is_array() || list.empty()) fields.refuse("has no list of fields");
  for (std::size_t i = 0; i < list.size(); ++i)
    report.fields.push_back(readField(list[i], where + ", field " + std::to_string(i + 1), report, trouble));
  return report;
}

ArmTable readArm(const Json& json, std::string& trouble) {
  ArmTable arm;
  Fields fields(json, "'arm'", trouble);
  arm.length_mm = fields.three("length_mm", 1, 2000);
  arm.countsPerTurn = fields.three("counts_per_turn", 1, 1e6);
  arm.bodyTurnsPerMotorTurn = fields.three("body_turns_per_motor_turn", -10, 10);
  arm.torque_NmmPermA = fields.three("torque_Nmm_per_mA", 1e-6, 10);
  arm.homeAngle_deg = fields.three("home_angle_deg", -360, 360);
  const auto centre = fields.three("centre_mm", -2000, 2000);
  arm.centre_mm = {centre[0], centre[1], centre[2]};
  arm.mostCurrent_mA = fields.number("most_current_mA", 1, 32767);
  for (const double turns : arm.bodyTurnsPerMotorTurn)
    if (turns == 0) fields.refuse("'body_turns_per_motor_turn' holds a 0");
  return arm;
}

DeviceLimits readLimits(const Json& json, std::string& trouble) {
  DeviceLimits limits;
  Fields fields(json, "'limits'", trouble);
  limits.sensedAxes = fields.whole("sensed_axes", 0, 6);
  limits.forceAxes = fields.whole("force_axes", 0, 6);
  const auto box = fields.three("workspace_mm", 0, 5000);
  limits.workspace_mm = {box[0], box[1], box[2]};
  limits.maxForce_N = fields.number("max_force_N", 0, 100, 0);
  limits.continuousForce_N = fields.number("continuous_force_N", 0, 100, 0);
  limits.maxTorque_Nmm = fields.number("max_torque_Nmm", 0, 10000, 0);
  limits.maxStiffness_Npmm = fields.number("max_stiffness_Npmm", 0, 100, 0);
  limits.rate_Hz = fields.number("rate_Hz", 1, 10000);
  limits.resolution_mm = fields.number("resolution_mm", 0, 10, 0);
  limits.damping_Nspm = fields.number("damping_Nspm", 0, 1000, 0);
  limits.friction_N = fields.number("friction_N", 0, 100, 0);
  limits.mass_kg = fields.number("mass_kg", 0, 100, 0);
  for (const int axes : {limits.sensedAxes, limits.forceAxes})
    if (axes != 0 && axes != 3 && axes != 6)
      fields.refuse("tells of " + std::to_string(axes) + " axes; there are 0, 3 or 6");
  if (limits.continuousForce_N > limits.maxForce_N) fields.refuse("'continuous_force_N' is above 'max_force_N'");
  return limits;
}

void readMatches(const Json& list, DeviceTable& table, Fields& fields, std::string& trouble) {
  if (!list.is_array() || list.empty()) fields.refuse("matches no device");
  for (std::size_t i = 0; i < list.size(); ++i) {
    Fields match(list[i], "match " + std::to_string(i + 1), trouble);
    DeviceMatch m;
    m.vendor = match.id("vendor");
    m.product = match.id("product");
    m.usagePage = match.optionalId("usage_page");
    m.usage = match.optionalId("usage");
    if (match.has("name")) m.name = match.text("name");
    table.matches.push_back(m);
  }
}

DeviceKind readKind(Fields& fields) {
  const std::string name = fields.text("kind");
  for (const DeviceKind kind : {DeviceKind::kForce, DeviceKind::kMotion, DeviceKind::kPedal})
    if (name == nameOf(kind)) return kind;
  fields.refuse("'kind' is '" + name + "'; it can be 'force', 'motion' or 'pedal'");
  return DeviceKind::kMotion;
}

bool needsArm(const ReportLayout& report) {
  return std::any_of(report.fields.begin(), report.fields.end(),
                     [](const ReportField& f) { return f.quantity == Quantity::kCurrent; });
}

DeviceTable readTable(const Json& json, std::string& trouble) {
  DeviceTable table;
  Fields fields(json, "The table", trouble);
  fields.whole("version", 1, 1);
  table.name = fields.text("name");
  table.kind = readKind(fields);
  table.source = fields.text("source");
  readMatches(fields.at("match"), table, fields, trouble);
  const Json& input = fields.at("input");
  if (!input.is_array() || input.empty()) fields.refuse("has no list of input reports");
  for (std::size_t i = 0; i < input.size(); ++i)
    table.input.push_back(readLayout(input[i], "input report " + std::to_string(i + 1), trouble));
  if (fields.has("output")) table.output = readLayout(json.at("output"), "the output report", trouble);
  if (fields.has("arm")) table.arm = readArm(json.at("arm"), trouble);
  table.limits = readLimits(fields.at("limits"), trouble);
  if (table.kind == DeviceKind::kForce && !table.output) fields.refuse("is of a force device, but has no 'output'");
  if (table.kind == DeviceKind::kForce && table.limits.maxForce_N <= 0) fields.refuse("is of a force device of 0 N");
  if (table.output && needsArm(*table.output) && !table.arm) fields.refuse("sends currents, but has no 'arm'");
  return table;
}

}  // namespace

std::string_view nameOf(DeviceKind kind) {
  return kind == DeviceKind::kForce ? "force" : kind == DeviceKind::kMotion ? "motion" : "pedal";
}

Result<DeviceTable> parseDeviceTable(std::string_view text) {
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::exception& e) {
    return fail("The device table is not JSON: " + jsonProblem(e.what()));
  }
  std::string trouble;
  DeviceTable table = readTable(json, trouble);
  if (!trouble.empty()) return fail("The device table cannot be used: " + trouble);
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
