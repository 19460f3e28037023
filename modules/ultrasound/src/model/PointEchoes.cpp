#include "model/PointEchoes.h"

#include <cmath>

namespace insonate {

std::vector<PointEcho> pointEchoes(const FramePlan& plan, const std::vector<PointTarget>& points,
                                   const Transform& patientFromProbe) {
  std::vector<PointEcho> echoes;
  const Transform probeFromPatient = inverted(patientFromProbe);
  for (const PointTarget& point : points) {
    const Vec3 p = probeFromPatient * point.position_mm;
    const auto at = plan.grid.locate(p.x, p.z);
    const double gate = (at.sample + 0.5) / plan.stride - 0.5;
    const int g0 = static_cast<int>(std::floor(gate)), l0 = static_cast<int>(std::floor(at.scanline));
    if (!at.inside || g0 < 0 || g0 >= plan.gates) continue;
    const double elevation_sd = p.y / plan.elevationSd_mm[g0];
    const double* lateralKernel = plan.lateralKernel.data() + std::size_t(g0) * (plan.maxLateralRadius + 1);
    const double next = plan.maxLateralRadius > 0 ? lateralKernel[1] : 0;
    const double peak = plan.boundaryScale / (0.75 * lateralKernel[0] + 0.25 * next);
    const double amplitude = point.amplitude * std::exp(-0.5 * elevation_sd * elevation_sd) * peak;
    const ImpulseWeights axial = impulseAt(gate - g0), lateral = impulseAt(at.scanline - l0);
    for (int o = 0; o < 4; ++o)
      for (int q = 0; q < 4; ++q) {
        const int g = g0 - 1 + o, l = l0 - 1 + q;
        const double share = axial.weight[o] * lateral.weight[q];
        if (g >= 0 && g < plan.gates && l >= 0 && l < plan.lines && share > 0)
          echoes.push_back({g, l, static_cast<float>(amplitude * share)});
      }
  }
  return echoes;
}

}  // namespace insonate
