#pragma once

#include <insonate/ultrasound/ImagingSettings.h>

namespace insonate {

/// Full widths at half maximum of the amplitude point-spread function that a probe has with these settings.
double axialFwhm_mm(const Probe& probe, const ImagingSettings& settings);
double lateralFwhm_mm(const Probe& probe, const ImagingSettings& settings, double range_mm);
double elevationFwhm_mm(const Probe& probe, const ImagingSettings& settings, double range_mm);

/// Assumed by the machine, whatever the tissue.
inline constexpr double kSoundSpeed_mmPerUs = 1.54;

}  // namespace insonate
