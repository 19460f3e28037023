#include "PointSpread.h"

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

double wavelength_mm(const ImagingSettings& settings) {
  return kSoundSpeed_mmPerUs / settings.frequency_MHz;
}

}  // namespace

double axialFwhm_mm(const Probe& probe, const ImagingSettings& settings) {
  return probe.axialFwhm_wavelengths * wavelength_mm(settings);
}

double lateralFwhm_mm(const Probe& probe, const ImagingSettings& settings, double range_mm) {
  const double atFocus_mm =
      wavelength_mm(settings) * std::max(probe.lateralFNumber, settings.focus_mm / probe.maxAperture_mm);
  const double off_mm = range_mm - settings.focus_mm;
  return std::hypot(atFocus_mm, off_mm * (off_mm < 0 ? probe.lateralDivergenceNear : probe.lateralDivergenceFar));
}

double elevationFwhm_mm(const Probe& probe, const ImagingSettings& settings, double range_mm) {
  return std::hypot(wavelength_mm(settings) * probe.elevationFwhm_wavelengths,
                    probe.elevationDivergence * (range_mm - probe.elevationFocus_mm));
}

}  // namespace insonate
