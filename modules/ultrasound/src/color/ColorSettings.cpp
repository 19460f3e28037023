#include <insonate/core/JsonEntry.h>
#include <insonate/core/Range.h>
#include <insonate/ultrasound/ColorSettings.h>
#include <insonate/ultrasound/PointSpread.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate {
namespace {

struct ColorNumber {
  std::string_view name;
  double ColorSettings::*member;
  double low, high;
};
constexpr ColorNumber kColorNumbers[] = {
    {"left", &ColorSettings::left, 0, 1},
    {"right", &ColorSettings::right, 0, 1},
    {"near_mm", &ColorSettings::near_mm, 0, 400},
    {"far_mm", &ColorSettings::far_mm, 1, 400},
    {"steering_deg", &ColorSettings::steering_deg, -20, 20},
    {"frequency_MHz", &ColorSettings::frequency_MHz, 1, 20},
    {"prf_Hz", &ColorSettings::prf_Hz, 200, 20000},
    {"gain_dB", &ColorSettings::gain_dB, -30, 30},
    {"wallFilter_Hz", &ColorSettings::wallFilter_Hz, 0, 10000},
    {"priority", &ColorSettings::priority, 0, 1},
    {"persistence", &ColorSettings::persistence, 0, 0.95},
};
constexpr double kLeastWidth = 0.05, kLeastHeight_mm = 2;
const std::vector<std::string_view> kColorModes{"velocity", "power"};
const std::string kColor = "The color settings";

/// The echo from the lower end of the box arrives before the next pulse.
double highestPrf_Hz(const ColorSettings& color) {
  return std::min(20000.0, std::floor(kSoundSpeed_mmPerUs * 1e6 / (2 * color.far_mm)));
}

Result<void> checkBox(const ColorSettings& color, const Probe& probe, const ImagingSettings& settings) {
  if (color.right - color.left < kLeastWidth)
    return fail("color: right must exceed left by at least 0.05; the box is a part of the width of the image.");
  if (color.far_mm - color.near_mm < kLeastHeight_mm)
    return fail("color: far_mm must exceed near_mm by at least 2 mm.");
  const double steering_deg = probe.shape == ProbeShape::Linear ? color.steering_deg : 0;
  const double deepest_mm = settings.depth_mm / std::cos(steering_deg * std::numbers::pi / 180);
  return checkRange(color.far_mm, 1, deepest_mm, "color: far_mm");
}

}  // namespace

ColorSettings colorSettingsFor(const Probe& probe, const ImagingSettings& settings) {
  ColorSettings color;
  color.near_mm = 0.2 * settings.depth_mm, color.far_mm = 0.9 * settings.depth_mm;
  // Color uses the lower part of the band, which attenuation weakens less.
  color.frequency_MHz = std::max(probe.minFrequency_MHz, 0.67 * probe.defaultFrequency_MHz);
  color.prf_Hz = std::min(color.prf_Hz, highestPrf_Hz(color));
  color.wallFilter_Hz = 0.015 * color.prf_Hz;  // low, since flow in veins is slow
  return color;
}

double nyquistVelocity_mmps(const ColorSettings& color) {
  return kSoundSpeed_mmPerUs * color.prf_Hz / (4 * color.frequency_MHz);
}

Result<ColorSettings> colorFromJson(const nlohmann::json& overrides, ColorSettings color) {
  std::vector<std::string_view> known{"packet", "mode", "invert"};
  for (const ColorNumber& field : kColorNumbers) known.push_back(field.name);
  if (!overrides.is_object()) return fail(kColor + " must be an object, such as {\"prf_Hz\": 3000}.");
  JsonEntry entry(overrides, kColor, known);
  for (const auto& [name, member, low, high] : kColorNumbers)
    color.*member = entry.optionalNumber(name, low, high).value_or(color.*member);
  color.packet = entry.optionalInteger("packet", 3, 32).value_or(color.packet);
  if (entry.has("mode")) color.mode = static_cast<ColorMode>(entry.word("mode", kColorModes));
  if (entry.has("invert")) color.invert = entry.flag("invert");
  if (!entry.error().empty()) return fail(entry.error());
  return color;
}

nlohmann::json jsonOf(const ColorSettings& color) {
  nlohmann::json object = {
      {"packet", color.packet}, {"mode", kColorModes[static_cast<std::size_t>(color.mode)]}, {"invert", color.invert}};
  for (const ColorNumber& field : kColorNumbers) object[std::string(field.name)] = color.*field.member;
  return object;
}

Result<void> validate(const ColorSettings& color, const Probe& probe, const ImagingSettings& settings) {
  for (const auto& [name, member, low, high] : kColorNumbers)
    if (auto ok = checkRange(color.*member, low, high, "color: " + std::string(name)); !ok) return ok;
  if (auto ok = checkRange(color.packet, 3, 32, "color: packet"); !ok) return ok;
  if (auto ok = checkBox(color, probe, settings); !ok) return ok;
  if (auto ok = checkRange(color.prf_Hz, 200, highestPrf_Hz(color), "color: prf_Hz"); !ok) return ok;
  return checkRange(color.wallFilter_Hz, 0, color.prf_Hz / 2, "color: wallFilter_Hz");
}

}  // namespace insonate
