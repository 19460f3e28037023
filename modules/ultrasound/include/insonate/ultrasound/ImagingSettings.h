#pragma once

#include <insonate/core/Result.h>
#include <insonate/ultrasound/Probe.h>

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <filesystem>
#include <string>

namespace insonate {

enum class Look {
  Coherent,  ///< scatterers fixed in the tissue, point-spread function, several looks (default)
  Thesis,    ///< the thesis's four layers: reflection, absorption, radial blur, Perlin speckle
};

/// Mapping of levels to grays; GrayMaps.h has the names and curves.
enum class GrayMap { Linear, Soft, Contrast, Bright, Dark, Flat };

/// Switches of the physical effects, to see the contribution of each.
struct Effects {
  bool scattering = true;  ///< off: nothing but boundaries
  bool reflection = true;
  bool attenuation = true;    ///< absorption along the beam, there and back
  bool transmission = true;   ///< loss (1 - R^2) at each boundary, there and back: shadow
  bool speckle = true;        ///< off: uniform scattering of the same mean power
  bool layers = true;         ///< walls, fascia and other connective layers at boundaries
  bool texture = true;        ///< septa, lobules, and modulation by the CT
  bool beam = true;           ///< the point-spread function
  bool reverberation = true;  ///< behind air
  bool edgeShadow = true;     ///< refraction at the sides of vessels
  bool clutter = true;        ///< haze in lumens (display path)
  bool noise = true;          ///< of the receiver's electronics (display path)
  bool nearField = true;      ///< ringing below the face, poor contact at the array's ends (display path)

  static constexpr Effects none() {
    return {false, false, false, false, false, false, false, false, false, false, false, false, false};
  }
};
static_assert(sizeof(Effects) == 13, "Effects::none() switches off every one");

/// Settings of the operator and the renderer. Defaults suit the linear probe on a neck; see settingsFor().
struct ImagingSettings {
  double depth_mm = 40;
  double frequency_MHz = 7.5;  ///< received; with harmonic imaging twice the transmitted one
  bool harmonic = false;       ///< tissue harmonic imaging: narrower beam, less haze, more noise
  double focus_mm = 20;
  double gain_dB = 0;              ///< -40..40
  std::array<double, 8> tgc_dB{};  ///< sliders from face to depth, -20..20, on top of the built-in compensation
  double dynamicRange_dB = 60;     ///< 20..120
  double persistence = 0;          ///< share of the previous image, 0..0.95
  GrayMap grayMap = GrayMap::Soft;
  double speckleReduction = 0.4;  ///< share of the image that is smoothed along interfaces, 0..1
  double edgeEnhancement = 0;     ///< of changes along the beam, 0..1
  double dynamicFilter = 0;       ///< growth of the pulse's length per 30 mm of depth, in lengths at the face; 0..2
  double noise_dB = -44;          ///< RMS of the receiver's noise in one look over unit speckle, before TGC; -120..0
  double ringing_dB = 10;         ///< the transmitted pulse at the face over unit speckle; -20..60
  double poorContactLeft_mm = 0, poorContactRight_mm = 0;  ///< strips of the face that the skin does not touch; 0..30
  std::array<double, 8> lateralGain_dB{};                  ///< sliders from the left to the right scanline, -20..20
  int looks = 3;                                           ///< compounded, 1..3
  double steering_deg = 0;                                 ///< of the scanlines toward +x, linear probes only; -20..20
  int compoundingAngles = 1;      ///< spatial compounding, linear probes only: 1, 3 or 5, see steeringAngles_deg()
  int scanlines = 256;            ///< 16..1024
  int samples = 1000;             ///< per scanline, 64..4096
  int elevationPlanes = 3;        ///< odd, 1..9
  int width = 820, height = 616;  ///< of the image, 64..4096
  bool conformingContact = true;  ///< skin follows the face, as under gel and light pressure
  Look look = Look::Coherent;
  double time_s = 0;  ///< seeds electronic noise and the thesis look's speckle, to the millisecond; 0..1e6
  Effects effects;
};

/// The defaults with the probe's own depth, frequency and focus.
ImagingSettings settingsFor(const Probe& probe);
/// Overrides the given fields; unknown names, wrong types and values out of range are refused by name.
Result<ImagingSettings> settingsFromJson(const nlohmann::json& overrides, ImagingSettings base);
Result<ImagingSettings> loadSettings(const std::filesystem::path& file, ImagingSettings base);
Result<void> validate(const ImagingSettings& settings, const Probe& probe);

}  // namespace insonate
