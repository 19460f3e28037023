#include <insonate/ultrasound/PointSpread.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate {
namespace {

/// Depth to which ImagingSettings::dynamicFilter refers.
constexpr double kFilterDepth_mm = 30;

double widthPerFNumber(Apodization apodization) {
  switch (apodization) {
    case Apodization::Uniform:
      return 1.3;
    case Apodization::Tukey:
      return 1.65;
    case Apodization::Hann:
      break;
  }
  return 2.17;
}

}  // namespace

double wavelength_mm(const ImagingSettings& settings) {
  return kSoundSpeed_mmPerUs / settings.frequency_MHz;
}

double transmitAperture_mm(const Probe& probe, const ImagingSettings& settings) {
  return std::min(settings.focus_mm / probe.transmitFNumber, probe.maxAperture_mm);
}

double receiveAperture_mm(const Probe& probe, double range_mm) {
  return std::min(range_mm / probe.receiveFNumber, probe.maxAperture_mm);
}

double axialFwhm_mm(const Probe& probe, const ImagingSettings& settings) {
  // Envelope of a Gaussian spectrum with half amplitude at +-B f / 2: its length is 4 ln 2 / (pi B f), times c / 2.
  return 4 * std::numbers::ln2 / std::numbers::pi / (probe.bandwidth * settings.frequency_MHz) * kSoundSpeed_mmPerUs /
         2;
}

double axialFwhm_mm(const Probe& probe, const ImagingSettings& settings, double range_mm) {
  return axialFwhm_mm(probe, settings) * (1 + settings.dynamicFilter * range_mm / kFilterDepth_mm);
}

double beamGrowth(const ImagingSettings& settings, double range_mm) {
  constexpr double kShare = 0.3;
  return 1 + kShare * settings.dynamicFilter * range_mm / kFilterDepth_mm;
}

double lateralFwhm_mm(const Probe& probe, const ImagingSettings& settings, double range_mm) {
  const double wavelength = wavelength_mm(settings);
  const double sent_mm = transmitAperture_mm(probe, settings), focus_mm = settings.focus_mm;
  const double receive_mm =
      widthPerFNumber(probe.apodization) * wavelength * range_mm / receiveAperture_mm(probe, range_mm);
  const double diffraction_mm = (settings.harmonic ? 2 : 1) * 1.44 * wavelength * focus_mm / sent_mm;
  const double sentWidth_mm = std::hypot(diffraction_mm, 0.47 * sent_mm * (range_mm - focus_mm) / focus_mm);
  // The square of a Gaussian beam.
  const double transmit_mm = settings.harmonic ? sentWidth_mm / std::numbers::sqrt2 : sentWidth_mm;
  return beamGrowth(settings, range_mm) / std::hypot(1 / transmit_mm, 1 / receive_mm);
}

double SliceLaw::thickness_mm(double range_mm) const {
  return std::hypot(narrowest_mm, (range_mm < at_mm ? growthBefore : growthBehind) * (range_mm - at_mm));
}

SliceLaw sliceLaw(const Probe& probe, double frequency_MHz) {
  const double height_mm = probe.elementHeight_mm, lens_mm = probe.elevationFocus_mm;
  const double wavelength = kSoundSpeed_mmPerUs / frequency_MHz;
  const double fresnelNumber = height_mm * height_mm / (4 * wavelength * lens_mm);
  SliceLaw law{};
  law.at_mm = lens_mm / (1 + 0.57 * std::pow(fresnelNumber, -1.3));
  law.narrowest_mm = 0.98 * wavelength * law.at_mm / height_mm;
  law.growthBefore = 0.935 * height_mm / law.at_mm;
  law.growthBehind = std::max(0.35 * height_mm / lens_mm - 0.06 * wavelength / height_mm, 0.0);
  return law;
}

}  // namespace insonate
