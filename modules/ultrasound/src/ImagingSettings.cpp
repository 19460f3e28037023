#include <insonate/core/JsonEntry.h>
#include <insonate/core/Preset.h>
#include <insonate/core/Range.h>
#include <insonate/ultrasound/GrayMaps.h>
#include <insonate/ultrasound/SetupText.h>

#include <nlohmann/json.hpp>

#include <algorithm>

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
const std::string kSetup = "The imaging setup";

template <class Fields>
void appendNames(const Fields& table, std::vector<std::string_view>& names) {
  for (const auto& field : table) names.push_back(field.name);
}

void readEffects(const Json& object, Effects& effects, std::string& trouble) {
  std::vector<std::string_view> known;
  appendNames(kEffects, known);
  JsonEntry entry(object, kSetup + ", effects,", known, trouble);
  for (const auto& field : kEffects)
    if (entry.has(field.name)) effects.*field.member = entry.flag(field.name);
}

/// The fields that the entry has.
void readSettings(JsonEntry& entry, Settings& settings) {
  for (const auto& [name, member, low, high] : kNumbers)
    settings.*member = entry.optionalNumber(name, low, high).value_or(settings.*member);
  for (const auto& [name, member, low, high] : kCounts)
    settings.*member = entry.optionalInteger(name, low, high).value_or(settings.*member);
  for (const auto& [name, member] : kSwitches)
    if (entry.has(name)) settings.*member = entry.flag(name);
  for (const auto& [name, member, order] : kSliders)
    if (entry.has(name))
      std::ranges::copy(entry.numbers(name, 8, -kSlider_dB, kSlider_dB, order), (settings.*member).begin());
  if (entry.has("grayMap")) settings.grayMap = static_cast<GrayMap>(entry.word("grayMap", kGrayMaps));
  if (entry.has("look")) settings.look = static_cast<Look>(entry.word("look", kLooks));
}

/// Files of former versions: `greyMap` is grayMap, and `smoothing` (on or off) is speckleReduction 1 or 0.
Json withPresentNames(Json object, std::string& trouble) {
  JsonEntry entry(object, kSetup, jsonKeys(object), trouble);
  for (const auto& [former, present] : {std::pair{"smoothing", "speckleReduction"}, {"greyMap", "grayMap"}}) {
    if (!entry.has(former)) continue;
    if (entry.has(present))
      entry.setError(std::string("has '") + former + "', which is the former name of '" + present + "'; leave it out.");
    object[present] = former == std::string_view("smoothing") ? Json(entry.flag(former) ? 1 : 0) : object[former];
    object.erase(former);
  }
  return object;
}

Result<void> checkSetting(double value, double low, double high, std::string_view name) {
  return checkRange(value, low, high, "settings: " + std::string(name));
}

/// Checks that do not depend on the probe.
Result<void> checkRanges(const Settings& settings) {
  for (const auto& [name, member, low, high] : kNumbers)
    if (auto ok = checkSetting(settings.*member, low, high, name); !ok) return ok;
  for (const auto& [name, member, low, high] : kCounts)
    if (auto ok = checkSetting(settings.*member, low, high, name); !ok) return ok;
  for (const auto& [name, member, order] : kSliders)
    for (const double slider_dB : settings.*member)
      if (auto ok = checkSetting(slider_dB, -kSlider_dB, kSlider_dB, name); !ok) return ok;
  if (settings.compoundingAngles % 2 == 0)
    return fail("settings: compoundingAngles is " + std::to_string(settings.compoundingAngles) +
                "; it must be odd, so that one angle is straight.");
  if (settings.elevationPlanes % 2 == 0)
    return fail("settings: elevationPlanes is " + std::to_string(settings.elevationPlanes) +
                "; it must be odd, so that one plane is the image plane.");
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
  std::string trouble;
  const Json object = withPresentNames(overrides, trouble);
  std::vector<std::string_view> known{"grayMap", "look", "effects"};
  appendNames(kNumbers, known);
  appendNames(kCounts, known);
  appendNames(kSwitches, known);
  appendNames(kSliders, known);
  JsonEntry entry(object, kSetup, known, trouble);
  readSettings(entry, base);
  if (entry.has("effects")) readEffects(entry.value("effects"), base.effects, trouble);
  if (!trouble.empty()) return fail(std::move(trouble));
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
  const auto text = readTextFile(file);
  if (!text) return tl::unexpected(text.error());
  const auto json = parsedJson(*text, file.string());
  if (!json) return tl::unexpected(json.error());
  auto settings = settingsFromJson(*json, base);
  if (!settings) return fail(file.string() + ": " + settings.error().message);
  return settings;
}

Result<void> validate(const ImagingSettings& settings, const Probe& probe) {
  if (auto ok = checkRanges(settings); !ok) return ok;
  const std::string where = "settings for the " + probe.name + " probe: ";
  if (auto ok = checkRange(settings.depth_mm, probe.minDepth_mm, probe.maxDepth_mm, where + "depth_mm"); !ok) return ok;
  return checkRange(settings.frequency_MHz, probe.minFrequency_MHz, probe.maxFrequency_MHz, where + "frequency_MHz");
}

}  // namespace insonate
