#include "JsonFields.h"

#include <insonate/ultrasound/GrayMaps.h>
#include <insonate/ultrasound/SetupText.h>

namespace insonate {
namespace {

using Settings = ImagingSettings;
using Json = nlohmann::json;

struct NumberField {
  std::string_view name;
  double Settings::*member;
  double low, high;
};
struct CountField {
  std::string_view name;
  int Settings::*member;
  int low, high;
};
struct SwitchField {
  std::string_view name;
  bool Settings::*member;
};
struct SlidersField {
  std::string_view name;
  std::array<double, 8> Settings::*member;
  std::string_view order;
};
struct EffectField {
  std::string_view name;
  bool Effects::*member;
};

constexpr NumberField kNumbers[] = {
    {"depth_mm", &Settings::depth_mm, 5, 400},
    {"frequency_MHz", &Settings::frequency_MHz, 0.5, 50},
    {"focus_mm", &Settings::focus_mm, 1, 400},
    {"gain_dB", &Settings::gain_dB, -40, 40},
    {"dynamicRange_dB", &Settings::dynamicRange_dB, 20, 120},
    {"persistence", &Settings::persistence, 0, 0.95},
    {"steering_deg", &Settings::steering_deg, -20, 20},
    {"speckleReduction", &Settings::speckleReduction, 0, 1},
    {"edgeEnhancement", &Settings::edgeEnhancement, 0, 1},
    {"dynamicFilter", &Settings::dynamicFilter, 0, 2},
    {"noise_dB", &Settings::noise_dB, -120, 0},
    {"ringing_dB", &Settings::ringing_dB, -20, 60},
    {"poorContactLeft_mm", &Settings::poorContactLeft_mm, 0, 30},
    {"poorContactRight_mm", &Settings::poorContactRight_mm, 0, 30},
    {"time_s", &Settings::time_s, 0, 1e6},
};
constexpr CountField kCounts[] = {
    {"looks", &Settings::looks, 1, 3},
    {"scanlines", &Settings::scanlines, 16, 1024},
    {"samples", &Settings::samples, 64, 4096},
    {"elevationPlanes", &Settings::elevationPlanes, 1, 9},
    {"width", &Settings::width, 64, 4096},
    {"height", &Settings::height, 64, 4096},
    {"compoundingAngles", &Settings::compoundingAngles, 1, 5},
};
constexpr SwitchField kSwitches[] = {
    {"conformingContact", &Settings::conformingContact},
    {"harmonic", &Settings::harmonic},
};
constexpr SlidersField kSliders[] = {
    {"tgc_dB", &Settings::tgc_dB, "from the face to the depth"},
    {"lateralGain_dB", &Settings::lateralGain_dB, "from left to right"},
};
constexpr EffectField kEffects[] = {
    {"scattering", &Effects::scattering},
    {"reflection", &Effects::reflection},
    {"attenuation", &Effects::attenuation},
    {"transmission", &Effects::transmission},
    {"speckle", &Effects::speckle},
    {"layers", &Effects::layers},
    {"texture", &Effects::texture},
    {"beam", &Effects::beam},
    {"reverberation", &Effects::reverberation},
    {"edgeShadow", &Effects::edgeShadow},
    {"clutter", &Effects::clutter},
    {"noise", &Effects::noise},
    {"nearField", &Effects::nearField},
};
constexpr double kSlider_dB = 20;
const std::vector<std::string_view> kGrayMaps = [] {
  std::vector<std::string_view> names;
  for (const GrayMapCurve& curve : grayMaps()) names.push_back(curve.name);
  return names;
}();
const std::vector<std::string_view> kLooks{"coherent", "thesis"};
const std::string kWhere = "settings";

/// Assigns the value of `result` to `target`, or returns its error.
template <class To, class From>
Result<void> assign(To& target, const Result<From>& result) {
  if (!result) return tl::unexpected(result.error());
  target = static_cast<To>(*result);
  return {};
}

template <class Fields>
void appendNames(const Fields& table, std::vector<std::string_view>& names) {
  for (const auto& field : table) names.push_back(field.name);
}

Result<void> readSliders(const Json& value, const SlidersField& field, Settings& settings) {
  std::array<double, 8>& sliders = settings.*field.member;
  const std::string name(field.name);
  if (!value.is_array() || value.size() != sliders.size())
    return fail(kWhere + ": " + name + " must be a list of 8 numbers, " + std::string(field.order) + ".");
  for (std::size_t i = 0; i < sliders.size(); ++i)
    if (auto ok = assign(sliders[i], fields::readNumber(value[i], name + "[" + std::to_string(i) + "]", kWhere)); !ok)
      return ok;
  return {};
}

Result<void> readEffects(const Json& value, Effects& effects) {
  std::vector<std::string_view> known;
  appendNames(kEffects, known);
  if (auto ok = fields::checkKeys(value, known, kWhere + ": effects"); !ok) return ok;
  for (const auto& field : kEffects) {
    const auto found = value.find(field.name);
    if (found == value.end()) continue;
    if (auto ok = assign(effects.*field.member, fields::readSwitch(*found, field.name, kWhere + ": effects")); !ok)
      return ok;
  }
  return {};
}

/// Reads one field, whose key is known.
Result<void> readField(std::string_view key, const Json& value, Settings& settings) {
  for (const auto& field : kNumbers)
    if (field.name == key) return assign(settings.*field.member, fields::readNumber(value, key, kWhere));
  for (const auto& field : kCounts)
    if (field.name == key) return assign(settings.*field.member, fields::readInteger(value, key, kWhere));
  for (const auto& field : kSwitches)
    if (field.name == key) return assign(settings.*field.member, fields::readSwitch(value, key, kWhere));
  for (const auto& field : kSliders)
    if (field.name == key) return readSliders(value, field, settings);
  if (key == "grayMap") return assign(settings.grayMap, fields::readChoice(value, kGrayMaps, key, kWhere));
  if (key == "look") return assign(settings.look, fields::readChoice(value, kLooks, key, kWhere));
  return readEffects(value, settings.effects);
}

/// Files of former versions: `greyMap` is grayMap, and `smoothing` (on or off) is speckleReduction 1 or 0.
Result<Json> withPresentNames(Json object) {
  if (!object.is_object()) return object;
  for (const auto& [former, present] : {std::pair{"smoothing", "speckleReduction"}, {"greyMap", "grayMap"}}) {
    const auto found = object.find(former);
    if (found == object.end()) continue;
    if (object.contains(present))
      return fail(kWhere + ": " + former + " is the former name of " + present + "; leave it out.");
    Json value = *found;
    if (present == std::string_view("speckleReduction")) {
      const auto on = fields::readSwitch(value, former, kWhere);
      if (!on) return tl::unexpected(on.error());
      value = *on ? 1 : 0;
    }
    object.erase(found);
    object[present] = std::move(value);
  }
  return object;
}

/// Checks that do not depend on the probe.
Result<void> checkRanges(const Settings& settings) {
  for (const auto& field : kNumbers)
    if (auto ok = fields::checkRange(settings.*field.member, field.low, field.high, field.name, kWhere); !ok) return ok;
  for (const auto& field : kCounts)
    if (auto ok = fields::checkRange(settings.*field.member, field.low, field.high, field.name, kWhere); !ok) return ok;
  for (const auto& field : kSliders)
    for (std::size_t i = 0; i < (settings.*field.member).size(); ++i) {
      const std::string name = std::string(field.name) + "[" + std::to_string(i) + "]";
      if (auto ok = fields::checkRange((settings.*field.member)[i], -kSlider_dB, kSlider_dB, name, kWhere); !ok)
        return ok;
    }
  if (settings.compoundingAngles % 2 == 0)
    return fail(kWhere + ": compoundingAngles is " + std::to_string(settings.compoundingAngles) +
                "; it must be odd, so that one angle is straight.");
  if (settings.elevationPlanes % 2 == 0)
    return fail(kWhere + ": elevationPlanes is " + std::to_string(settings.elevationPlanes) +
                "; it must be odd, so that one plane is the imaging plane.");
  return {};
}

}  // namespace

ImagingSettings settingsFor(const Probe& probe) {
  ImagingSettings settings;
  settings.depth_mm = probe.defaultDepth_mm;
  settings.frequency_MHz = probe.defaultFrequency_MHz;
  settings.focus_mm = probe.defaultFocus_mm;
  return settings;
}

Result<ImagingSettings> settingsFromJson(const nlohmann::json& overrides, ImagingSettings base) {
  const auto object = withPresentNames(overrides);
  if (!object) return tl::unexpected(object.error());
  std::vector<std::string_view> known{"grayMap", "look", "effects"};
  appendNames(kNumbers, known);
  appendNames(kCounts, known);
  appendNames(kSwitches, known);
  appendNames(kSliders, known);
  if (auto ok = fields::checkKeys(*object, known, kWhere); !ok) return tl::unexpected(ok.error());
  for (const auto& [key, value] : object->items())
    if (auto ok = readField(key, value, base); !ok) return tl::unexpected(ok.error());
  if (auto ok = checkRanges(base); !ok) return tl::unexpected(ok.error());
  return base;
}

Json jsonOf(const ImagingSettings& settings) {
  Json object{{"grayMap", kGrayMaps[static_cast<std::size_t>(settings.grayMap)]},
              {"look", kLooks[static_cast<std::size_t>(settings.look)]},
              {"effects", Json::object()}};
  for (const auto& field : kNumbers) object[std::string(field.name)] = settings.*field.member;
  for (const auto& field : kCounts) object[std::string(field.name)] = settings.*field.member;
  for (const auto& field : kSwitches) object[std::string(field.name)] = settings.*field.member;
  for (const auto& field : kSliders) object[std::string(field.name)] = settings.*field.member;
  for (const auto& field : kEffects) object["effects"][std::string(field.name)] = settings.effects.*field.member;
  return object;
}

Result<ImagingSettings> loadSettings(const std::filesystem::path& file, ImagingSettings base) {
  const auto json = fields::parseFile(file);
  if (!json) return tl::unexpected(json.error());
  auto settings = settingsFromJson(*json, base);
  if (!settings) return fail(file.string() + ": " + settings.error().message);
  return settings;
}

Result<void> validate(const ImagingSettings& settings, const Probe& probe) {
  if (auto ok = checkRanges(settings); !ok) return ok;
  const std::string where = kWhere + " for the " + probe.name + " probe";
  if (auto ok = fields::checkRange(settings.depth_mm, probe.minDepth_mm, probe.maxDepth_mm, "depth_mm", where); !ok)
    return ok;
  return fields::checkRange(settings.frequency_MHz, probe.minFrequency_MHz, probe.maxFrequency_MHz, "frequency_MHz",
                            where);
}

}  // namespace insonate
