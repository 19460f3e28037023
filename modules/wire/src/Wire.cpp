#include <insonate/core/JsonEntry.h>
#include <insonate/core/Preset.h>
#include <insonate/core/Range.h>
#include <insonate/embedded/wires.h>
#include <insonate/wire/Wire.h>

#include <nlohmann/json.hpp>

namespace insonate {
namespace {

const std::vector<std::string_view> kKinds{"guidewire", "dilator", "catheter"};

struct Limits {
  double low, high;
};
constexpr Limits kDiameter{0.2, 6}, kInner{0, 5.7}, kFriction{0, 1}, kLength{0.1, 2000}, kStiffness{0.05, 20000},
    kRest{1, 1000}, kKink{0.5, 200};
constexpr double kMaxInnerShare = 0.95;

/// A number that states its source.
double sourced(JsonEntry& entry, const nlohmann::json& object, const char* key, Limits limits) {
  if (object.contains(key) && (!object[key].is_object() || object[key].value("source", std::string()).empty()))
    entry.setError("needs '" + std::string(key) + "' as an object with \"value\" and \"source\".");
  const auto value = entry.optionalNumberWithSource(key, limits.low, limits.high);
  if (!value) entry.setError("has no '" + std::string(key) + "'; add it.");
  return value.value_or(0);
}

WireSection readSection(const nlohmann::json& json, const std::string& where, std::string& error) {
  JsonEntry entry(json, where, {"name", "length_mm", "bendingStiffness_Nmm2", "restRadius_mm", "kinkRadius_mm"}, error);
  WireSection section;
  section.length_mm = sourced(entry, json, "length_mm", kLength);
  section.bendingStiffness_Nmm2 = sourced(entry, json, "bendingStiffness_Nmm2", kStiffness);
  if (entry.has("restRadius_mm")) section.restRadius_mm = sourced(entry, json, "restRadius_mm", kRest);
  section.kinkRadius_mm = sourced(entry, json, "kinkRadius_mm", kKink);
  return section;
}

}  // namespace

double lengthOf_mm(const Wire& wire) {
  double length_mm = 0;
  for (const WireSection& section : wire.sections) length_mm += section.length_mm;
  return length_mm;
}

std::string_view nameOf(WireKind kind) {
  return kKinds[std::size_t(kind)];
}

Result<void> validate(const Wire& wire) {
  const std::string where = "wire '" + wire.name + "': ";
  const auto check = [&](double value, Limits limits, const char* what) {
    return checkRange(value, limits.low, limits.high, where + what);
  };
  if (wire.sections.empty()) return fail(where + "it has no sections; add at least one.");
  constexpr std::size_t kMaxSections = 100;
  constexpr double kMaxLength_mm = 2000;
  if (wire.sections.size() > kMaxSections) return fail(where + "it has more than 100 sections.");
  if (lengthOf_mm(wire) > kMaxLength_mm) return fail(where + "it is longer than 2000 mm.");
  if (auto ok = check(wire.diameter_mm, kDiameter, "diameter_mm"); !ok) return ok;
  if (auto ok = check(wire.innerDiameter_mm, {0, kMaxInnerShare * wire.diameter_mm}, "innerDiameter_mm"); !ok)
    return ok;
  if (auto ok = check(wire.friction, kFriction, "friction"); !ok) return ok;
  for (const WireSection& section : wire.sections) {
    if (auto ok = check(section.length_mm, kLength, "length_mm"); !ok) return ok;
    if (auto ok = check(section.bendingStiffness_Nmm2, kStiffness, "bendingStiffness_Nmm2"); !ok) return ok;
    if (section.restRadius_mm != 0)
      if (auto ok = check(section.restRadius_mm, kRest, "restRadius_mm"); !ok) return ok;
    if (auto ok = check(section.kinkRadius_mm, kKink, "kinkRadius_mm"); !ok) return ok;
    if (section.restRadius_mm != 0 && section.restRadius_mm <= section.kinkRadius_mm)
      return fail(where +
                  "a section has a restRadius_mm that is not above its kinkRadius_mm, so that it is kinked at rest.");
  }
  return {};
}

std::vector<std::string> wirePresetNames() {
  return presetNames(embeddedPresets(embedded::wires::files()));
}

Result<Wire> loadWire(std::string_view nameOrPath) {
  return presetOrFile("a wire", nameOrPath, embeddedPresets(embedded::wires::files()), parseWire);
}

Result<Wire> parseWire(std::string_view text) {
  const auto json = parsedJson(text, "The wire");
  if (!json) return tl::unexpected(json.error());
  std::string error;
  JsonEntry entry(*json, "The wire",
                  {"name", "description", "sources", "kind", "diameter_mm", "innerDiameter_mm", "friction", "sections"},
                  error);
  Wire wire;
  wire.name = entry.text("name");
  wire.kind = static_cast<WireKind>(entry.word("kind", kKinds));
  wire.diameter_mm = sourced(entry, *json, "diameter_mm", kDiameter);
  if (entry.has("innerDiameter_mm")) wire.innerDiameter_mm = sourced(entry, *json, "innerDiameter_mm", kInner);
  wire.friction = sourced(entry, *json, "friction", kFriction);
  wire.sections = entry.list("sections", "section", readSection);
  if (!error.empty()) return fail(std::move(error));
  if (auto ok = validate(wire); !ok) return tl::unexpected(ok.error());
  return wire;
}

}  // namespace insonate
