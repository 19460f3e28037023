#pragma once

#include <insonate/core/Result.h>
#include <insonate/ultrasound/Probe.h>

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <filesystem>
#include <string>

namespace insonate {

enum class Look {
  Coherent,  ///< scatterers fixed in the tissue, blurred by the point-spread function; several renderings with
             ///< independent speckle are averaged (default)
  Thesis,    ///< rendering style of the thesis (see README.md): reflection, absorption, radial blur, Perlin speckle
};

/// Mapping of echo levels to gray values; GrayMaps.h has the names and curves.
enum class GrayMap { Linear, Soft, Contrast, Bright, Dark, Flat };

/// Switches of the simulated physical effects, by which the contribution of each effect can be shown.
struct Effects {
  bool scattering = true;  ///< scattering by tissue; off: only boundaries are shown
  bool reflection = true;
  bool attenuation = true;    ///< absorption along the beam, two-way
  bool transmission = true;   ///< two-way loss (1 - R^2) at each boundary, which causes shadows
  bool speckle = true;        ///< speckle; off: uniform scattering with the same mean power
  bool layers = true;         ///< echoes of walls, fascia and other connective layers at boundaries
  bool texture = true;        ///< fine structure of tissues (Texture), and modulation of the echo by the CT
  bool beam = true;           ///< blur by the point-spread function; off: the echo of a point is in a single sample
  bool reverberation = true;  ///< reverberation behind air
  bool edgeShadow = true;     ///< edge shadows: loss by refraction at the sides of vessels
  /// Haze: weak echoes that side lobes and reverberation add to dark regions (computed by the display).
  bool clutter = true;
  bool noise = true;  ///< noise of the receiver's electronics (computed by the display)
  /// Ringing of the elements below the face, and poor contact at the array's ends (computed by the display).
  bool nearField = true;

  static constexpr Effects none() {
    return {false, false, false, false, false, false, false, false, false, false, false, false, false};
  }
};
static_assert(sizeof(Effects) == 13, "Effects::none() switches off every one");

/// Settings of the simulated ultrasound machine and of the renderer. Defaults are for the linear probe on a neck; see
/// settingsFor().
struct ImagingSettings {
  double depth_mm = 40;
  double frequency_MHz = 7.5;  ///< frequency received; with harmonic imaging, twice the transmitted frequency
  /// Tissue harmonic imaging: narrower beam, weaker haze from side lobes and reverberation, more noise.
  bool harmonic = false;
  double focus_mm = 20;
  double gain_dB = 0;  ///< gain of the whole image, -40 to 40
  /// Gain sliders from the face to the image's depth, -20 to 20, in addition to the built-in compensation.
  std::array<double, 8> tgc_dB{};
  double dynamicRange_dB = 60;  ///< range of levels from black to white, 20 to 120
  double persistence = 0;       ///< share of the previous image in the displayed image, 0 to 0.95
  GrayMap grayMap = GrayMap::Soft;
  double speckleReduction = 0.4;  ///< weight of the image smoothed along interfaces in the displayed image, 0 to 1
  double edgeEnhancement = 0;     ///< strength of the enhancement of changes along the beam, 0 to 1
  /// Increase of the pulse's length per 30 mm of depth, as a fraction of its length at the face; 0 to 2.
  double dynamicFilter = 0;
  /// RMS of the receiver's noise in one look, before TGC, relative to the speckle of a tissue of 0 dB; -120 to 0.
  double noise_dB = -44;
  /// Level of the ringing of the elements at the face, relative to the speckle of a tissue of 0 dB; -20 to 60.
  double ringing_dB = 10;
  /// Widths of strips at the left and right ends of the face that do not touch the skin; 0 to 30.
  double poorContactLeft_mm = 0, poorContactRight_mm = 0;
  std::array<double, 8> lateralGain_dB{};  ///< gain sliders from the left to the right scanline, -20 to 20
  int looks = 3;            ///< number of looks: renderings with independent speckle that are averaged; 1 to 3
  double steering_deg = 0;  ///< angle of the scanlines toward +x, linear probes only; -20 to 20
  /// Number of angles of spatial compounding, linear probes only: 1, 3 or 5, see steeringAngles_deg().
  int compoundingAngles = 1;
  int scanlines = 256;  ///< number of scanlines, 16 to 1024
  int samples = 1000;   ///< number of samples per scanline, 64 to 4096
  /// number of planes, distributed over the slice thickness, whose echoes are summed; odd, 1 to 9
  int elevationPlanes = 3;
  int width = 820, height = 616;  ///< size of the image in pixels, 64 to 4096
  /// true: the face has contact with the skin over its whole width, as with gel and light pressure
  bool conformingContact = true;
  Look look = Look::Coherent;
  /// time of the image, 0 to 1e6; rounded to 1 ms, it is the seed of the electronic noise and of the speckle of
  /// Look::Thesis
  double time_s = 0;
  Effects effects;
};

/// Returns the default settings with the probe's own depth, frequency and focus.
ImagingSettings settingsFor(const Probe& probe);
/// Returns `base` with the fields that `overrides` contains replaced. Fails with a sentence that names the field on
/// unknown names, wrong types and values out of range.
Result<ImagingSettings> settingsFromJson(const nlohmann::json& overrides, ImagingSettings base);
Result<ImagingSettings> loadSettings(const std::filesystem::path& file, ImagingSettings base);
Result<void> validate(const ImagingSettings& settings, const Probe& probe);

}  // namespace insonate
