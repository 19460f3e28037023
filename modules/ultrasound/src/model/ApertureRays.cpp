#include "model/ApertureRays.h"

#include <algorithm>

namespace insonate {

ApertureRays::ApertureRays(const Probe& probe, const ImagingSettings& settings, const BeamGrid& grid, int gates,
                           double gate_mm) {
  const double tangent = 0.25 * (1 / probe.transmitFNumber + 1 / probe.receiveFNumber);
  for (int gate = 0; gate < gates; ++gate) {
    const double range_mm = (gate + 0.5) * gate_mm;
    const double here = std::min(tangent, probe.maxAperture_mm / 2 / range_mm);
    const double lines = here * gate_mm / grid.scanlineSpacing_mm(range_mm);
    cone_lines.push_back(settings.effects.beam ? std::min(lines, 1.0) : 0);
  }
}

}  // namespace insonate
