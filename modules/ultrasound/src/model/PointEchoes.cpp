#include "model/PointEchoes.h"

#include "model/PlaneShift.h"

#include <array>
#include <cmath>

namespace insonate {
namespace {

constexpr int kMaxShares = 16;

/// Shares of a point on the gates or scanlines around it, of unit sum.
struct Shares {
  int first = 0, count = 0;
  std::array<double, kMaxShares> weight{};
};

/// The kernels exclude the correlation of the scatterers' lattice, which a point does not have: the point is widened by
/// it. If this is less than the grid can represent, a cubic places the point without widening it.
Shares sharesAround(double position, double sd) {
  Shares s;
  if (sd < 0.5) {
    s.first = static_cast<int>(std::floor(position)) - 1, s.count = 4;
    const CubicWeights cubic = cubicAt(position - std::floor(position));
    for (int n = 0; n < 4; ++n) s.weight[n] = cubic.weight[n];
    return s;
  }
  const double reach = std::min(3.5 * sd, (kMaxShares - 1) / 2.0);
  s.first = static_cast<int>(std::ceil(position - reach));
  s.count = static_cast<int>(std::floor(position + reach)) - s.first + 1;
  double sum = 0;
  for (int n = 0; n < s.count; ++n) {
    const double off_sd = (s.first + n - position) / sd;
    s.weight[n] = std::exp(-0.5 * off_sd * off_sd);
    sum += s.weight[n];
  }
  for (double& w : s.weight) w /= sum;
  return s;
}

/// Response of half a kernel to shares around its center.
double peakOf(const double* half, int radius, double sd) {
  const Shares s = sharesAround(0, sd);
  double peak = 0;
  for (int n = 0; n < s.count; ++n)
    if (const int off = std::abs(s.first + n); off <= radius) peak += half[off] * s.weight[n];
  return peak;
}

}  // namespace

std::vector<PointEcho> pointEchoes(const FramePlan& plan, const std::vector<PointTarget>& points,
                                   const Transform& patientFromProbe, const PlaneDisplacement& displacement) {
  std::vector<PointEcho> echoes;
  const Transform probeFromPatient = inverted(patientFromProbe);
  const double grain_mm = plan.latticePitch_mm / std::sqrt(6);
  const double axialGrain = grain_mm / plan.gate_mm;
  for (const PointTarget& point : points) {
    const Vec3 p = seenFromRest(displacement, probeFromPatient * point.position_mm);
    const auto at = plan.grid.locate(p.x, p.z);
    const double gate = (at.sample + 0.5) / plan.stride - 0.5;
    if (!at.inside || gate <= -1 || gate >= plan.gates) continue;
    const int g0 = std::max(0, static_cast<int>(std::floor(gate)));
    const double axialPeak =
        peakOf(plan.axialKernel.data() + std::size_t(g0) * (plan.maxAxialRadius + 1), plan.axialRadius[g0], axialGrain);
    const double lateralGrain = grain_mm / plan.grid.scanlineSpacing_mm(plan.range_mm(gate));
    const double lateralPeak = peakOf(plan.lateralKernel.data() + std::size_t(g0) * (plan.maxLateralRadius + 1),
                                      plan.lateralRadius[g0], lateralGrain);
    const double seen = plan.field.elevation(p.y, plan.range_mm(gate));
    const double amplitude = point.amplitude * seen / (axialPeak * lateralPeak);
    const Shares axial = sharesAround(gate, axialGrain), lateral = sharesAround(at.scanline, lateralGrain);
    for (int o = 0; o < axial.count; ++o)
      for (int q = 0; q < lateral.count; ++q) {
        const int g = axial.first + o, l = lateral.first + q;
        const double share = axial.weight[o] * lateral.weight[q];
        if (g >= 0 && g < plan.gates && l >= 0 && l < plan.lines && share != 0)
          echoes.push_back({g, l, static_cast<float>(amplitude * share)});
      }
  }
  return echoes;
}

}  // namespace insonate
