#pragma once

#include <insonate/ultrasound/ImagingSettings.h>

namespace insonate {

/// Speed of sound that the machine assumes in all tissue.
inline constexpr double kSoundSpeed_mmPerUs = 1.54;

double wavelength_mm(const ImagingSettings& settings);

/// Active parts of the array.
double transmitAperture_mm(const Probe& probe, const ImagingSettings& settings);
double receiveAperture_mm(const Probe& probe, double range_mm);

/// Full width at half maximum of the amplitude point-spread function of a probe with these settings. The pulse is a
/// Gaussian of the probe's bandwidth. The other two are laws fitted to the field of an array and of a strip: within 10
/// % of the engines' for linear arrays, 20 % for others; for callers that need only a width.
double axialFwhm_mm(const Probe& probe, const ImagingSettings& settings);
/// Axial width at a depth: receive filters of machines narrow with depth, as attenuation takes the high frequencies.
double axialFwhm_mm(const Probe& probe, const ImagingSettings& settings, double range_mm);
double lateralFwhm_mm(const Probe& probe, const ImagingSettings& settings, double range_mm);
/// Ratio of the beam's width at a depth to that at the set frequency: attenuation takes the high frequencies, and a
/// dynamic filter follows the rest. A Gaussian band of SD s loses s^2 times the loss in Np/MHz of its center: with 60
/// % of 9 MHz and 0.6 dB/cm/MHz a quarter in 30 mm, there and back.
double beamGrowth(const ImagingSettings& settings, double range_mm);

/// Slice thickness by depth: hypot(narrowest, growth * distance from the narrowest place), before and behind it.
struct SliceLaw {
  double narrowest_mm, at_mm;  ///< thickness, and depth of the narrowest place: it lies before the lens's focus
  double growthBefore, growthBehind;

  double thickness_mm(double range_mm) const;
};
SliceLaw sliceLaw(const Probe& probe, double frequency_MHz);

}  // namespace insonate
