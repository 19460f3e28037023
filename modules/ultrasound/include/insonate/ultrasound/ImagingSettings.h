#pragma once

#include <insonate/core/Result.h>
#include <insonate/ultrasound/Probe.h>

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <filesystem>
#include <string>

namespace insonate {

enum class Look {
  Coherent,  ///< scatterers fixed in the tissue, point-spread function, several compounding looks (default)
  Thesis,    ///< the four layers of the thesis: reflection, absorption, radial blur, Perlin speckle
};

/// Mapping of levels to gray values; GrayMaps.h has the names and curves.
enum class GrayMap { Linear, Soft, Contrast, Bright, Dark, Flat };

/// Switches of the physical effects, to see the contribution of each.
struct Effects {
  bool scattering = true;  ///< off: only boundaries are shown
  bool reflection = true;
  bool attenuation = true;    ///< absorption along the beam, two-way
  bool transmission = true;   ///< two-way loss (1 - R^2) at each boundary, which causes shadows
  bool speckle = true;        ///< off: uniform scattering with the same mean power
  bool layers = true;         ///< walls, fascia and other connective layers at boundaries
  bool texture = true;        ///< septa, lobules, and modulation by the CT
  bool beam = true;           ///< the point-spread function
  bool reverberation = true;  ///< reverberation behind air
  bool edgeShadow = true;     ///< refraction at the sides of vessels
  bool clutter = true;        ///< haze in lumens (display path)
  bool noise = true;          ///< noise of the receiver's electronics (display path)
  bool nearField = true;      ///< ringing below the face, poor contact at the array's ends (display path)

  static constexpr Effects none() {
    return {false, false, false, false, false, false, false, false, false, false, false, false, false};
  }
};
static_assert(sizeof(Effects) == 13, "Effects::none() switches off every one");

/// Settings of the operator and the renderer. Defaults are for the linear probe on a neck; see settingsFor().
struct ImagingSettings {
  double depth_mm = 40;
  double frequency_MHz = 7.5;  ///< frequency received; with harmonic imaging, twice the transmitted frequency
  bool harmonic = false;       ///< tissue harmonic imaging: narrower beam, less haze, more noise
  double focus_mm = 20;
  double gain_dB = 0;              ///< -40..40
  std::array<double, 8> tgc_dB{};  ///< sliders from face to depth, -20..20, in addition to the built-in compensation
  double dynamicRange_dB = 60;     ///< 20..120
  double persistence = 0;          ///< share of the previous image, 0..0.95
  GrayMap grayMap = GrayMap::Soft;
  double speckleReduction = 0.4;  ///< share of the image that is smoothed along interfaces, 0..1
  double edgeEnhancement = 0;     ///< enhancement of changes along the beam, 0..1
  /// Growth of the pulse's length per 30 mm of depth, relative to its length at the face; 0..2.
  double dynamicFilter = 0;
  double noise_dB = -44;   ///< RMS of the receiver's noise in one look, relative to unit speckle, before TGC; -120..0
  double ringing_dB = 10;  ///< transmitted pulse at the face, relative to unit speckle; -20..60
  /// Widths of strips of the face without contact to the skin; 0..30.
  double poorContactLeft_mm = 0, poorContactRight_mm = 0;
  std::array<double, 8> lateralGain_dB{};  ///< sliders from the left to the right scanline, -20..20
  int looks = 3;                           ///< number of compounded looks, 1..3
  double steering_deg = 0;                 ///< angle of the scanlines toward +x, linear probes only; -20..20
  int compoundingAngles = 1;      ///< spatial compounding, linear probes only: 1, 3 or 5, see steeringAngles_deg()
  int scanlines = 256;            ///< 16..1024
  int samples = 1000;             ///< per scanline, 64..4096
  int elevationPlanes = 3;        ///< odd, 1..9
  int width = 820, height = 616;  ///< image size, 64..4096
  bool conformingContact = true;  ///< the skin follows the face, as with gel and light pressure
  Look look = Look::Coherent;
  double time_s = 0;  ///< seed, to the millisecond, of electronic noise and of the speckle of Look::Thesis; 0..1e6
  Effects effects;
};

/// Returns the default settings with the probe's own depth, frequency and focus.
ImagingSettings settingsFor(const Probe& probe);
/// Replaces the fields that are given in `overrides`. Fails, with the field's name, on unknown names, wrong types and
/// values out of range.
Result<ImagingSettings> settingsFromJson(const nlohmann::json& overrides, ImagingSettings base);
Result<ImagingSettings> loadSettings(const std::filesystem::path& file, ImagingSettings base);
Result<void> validate(const ImagingSettings& settings, const Probe& probe);

}  // namespace insonate
