#pragma once

#include <insonate/core/Result.h>
#include <insonate/ultrasound/ImagingSettings.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

namespace insonate {

/// Quantity that the color shows: the mean velocity along the beam, or the power of the moving echoes.
enum class ColorMode { Velocity, Power };

/// Settings of color Doppler, beside those of the B-mode image.
struct ColorSettings {
  /// Lateral borders of the color box, as fractions of the field of view from its left edge (0) to its right edge (1),
  /// measured at the face; `right` is greater by at least 0.05.
  double left = 0.25, right = 0.75;
  double near_mm = 8,
         far_mm = 32;        ///< range of the box from the face, along its scanlines; far is greater by 2 or more
  double steering_deg = 0;   ///< angle of the color scanlines toward +x, linear probes only; -20 to 20
  double frequency_MHz = 5;  ///< frequency of the transmitted pulses, 1 to 20
  /// Pulse repetition frequency, 200 to 20000; the echo from `far_mm` must arrive before the next pulse.
  double prf_Hz = 3000;
  double gain_dB = 0;         ///< gain of color, -30 to 30
  double wallFilter_Hz = 80;  ///< cutoff of the filter that suppresses slow tissue, 0 to half the PRF
  /// Gray level of the B-mode image, 0 to 1, above which a pixel shows tissue instead of color.
  double priority = 0.65;
  double persistence = 0.4;  ///< share of the previous color image in the displayed one, 0 to 0.95
  int packet = 10;           ///< number of pulses per scanline, 3 to 32
  ColorMode mode = ColorMode::Velocity;
  bool invert = false;  ///< false: flow toward the probe is red; true: flow away from the probe is red

  bool operator==(const ColorSettings&) const = default;
};

/// Returns the default settings of a probe: a box in the middle of the image.
ColorSettings colorSettingsFor(const Probe& probe, const ImagingSettings& settings);

/// Returns the velocity along the beam above which velocities alias (Nyquist velocity), mm/s: c PRF / (4 f).
double nyquistVelocity_mmps(const ColorSettings& color);

/// Returns `base` with the fields that `overrides` contains replaced. Fails with a sentence that names the field.
Result<ColorSettings> colorFromJson(const nlohmann::json& overrides, ColorSettings base);
nlohmann::json jsonOf(const ColorSettings& color);
/// Checks ranges, the size of the box, and that the box lies within the depth of the image.
Result<void> validate(const ColorSettings& color, const Probe& probe, const ImagingSettings& settings);

}  // namespace insonate
