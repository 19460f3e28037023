#include "model/FramePlan.h"

#include "PointSpread.h"
#include "model/Scatterers.h"

#include <insonate/core/Hash.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

constexpr double kPlaneSpacing_sd = 1.2;
constexpr double kCellDepth_mm = 0.4, kCellWidth_mm = 0.4;
constexpr int kMaxKernelRadius = 32;

/// Half of a sampled Gaussian of unit sum, cut at 3 SD.
std::vector<double> halfKernel(double sd_samples) {
  const int radius = std::min(static_cast<int>(std::ceil(3 * sd_samples)), kMaxKernelRadius);
  std::vector<double> half(radius + 1);
  double sum = 0;
  for (int o = 0; o <= radius; ++o) {
    half[o] = o == 0 ? 1 : std::exp(-0.5 * o * o / (sd_samples * sd_samples));
    sum += o == 0 ? half[o] : 2 * half[o];
  }
  for (double& w : half) w /= sum;
  return half;
}

/// Sum over i of kernel[i] * kernel[i + lag], for the lags 0, 1, ... at which it is not zero.
std::vector<double> autocorrelation(const std::vector<double>& half) {
  const int radius = static_cast<int>(half.size()) - 1;
  std::vector<double> sums(2 * radius + 1);
  for (int lag = 0; lag <= 2 * radius; ++lag)
    for (int i = -radius; i + lag <= radius; ++i) sums[lag] += half[std::abs(i)] * half[std::abs(i + lag)];
  return sums;
}

}  // namespace

CubicWeights cubicAt(double t) {
  return {{t * (-0.5 + t * (1 - 0.5 * t)), 1 + t * t * (-2.5 + 1.5 * t), t * (0.5 + t * (2 - 1.5 * t)),
           t * t * (-0.5 + 0.5 * t)}};
}

FramePlan::FramePlan(const Probe& p, const ImagingSettings& s) : probe(p), settings(s), grid(p, s) {
  const double pulse_mm = axialFwhm_mm(p, s);
  lines = grid.scanlines();
  stride = std::max(1, static_cast<int>(pulse_mm / 3 / grid.step_mm()));
  gates = (grid.samples() + stride - 1) / stride;
  gate_mm = stride * grid.step_mm();
  cellGates = std::clamp(static_cast<int>(kCellDepth_mm / gate_mm), 1, 4);
  cellLines = grid.scanlineSpacing_mm(s.depth_mm) * 2 <= kCellWidth_mm ? 2 : 1;
  nodeRows = (gates + cellGates - 1) / cellGates + 1;
  nodeColumns = (lines + cellLines - 1) / cellLines + 1;
  const auto steering_deg =
      static_cast<std::int32_t>(std::lround(probe.shape == ProbeShape::Linear ? s.steering_deg : 0));
  if (steering_deg != 0) specklePattern = hash32(static_cast<std::uint32_t>(steering_deg));
  latticePitch_mm = 0.58 * pulse_mm;
  latticeElevationPitch_mm = 3 * latticePitch_mm;
  planeElevation();
  planeBeam();
}

void FramePlan::planeElevation() {
  const int planes = settings.elevationPlanes;
  double sum = 0;
  for (int p = 0; p < planes; ++p) {
    planeOffset_sd.push_back((p - (planes - 1) / 2) * kPlaneSpacing_sd * (planes > 3 ? 3.0 / planes * 1.4 : 1.0));
    scatterWeight.push_back(std::exp(-0.5 * planeOffset_sd[p] * planeOffset_sd[p]));
    sum += scatterWeight[p];
  }
  for (const double w : scatterWeight) boundaryWeight.push_back(w / sum);
  if (planes > 1) planeSpacing_sd = planeOffset_sd[1] - planeOffset_sd[0];
  for (int g = 0; g < gates; ++g)
    elevationSd_mm.push_back(elevationFwhm_mm(probe, settings, range_mm(g)) / acoustics::kFwhmPerSd);
}

double FramePlan::speckleVariance(int gate, const std::vector<double>& axialLags,
                                  const std::vector<double>& lateralLags) const {
  const double lineStep_pitches = grid.scanlineSpacing_mm(range_mm(gate)) / latticePitch_mm;
  const double gateStep_pitches = gate_mm / latticePitch_mm;
  const std::vector<double>& w = scatterWeight;
  double variance = 0;
  for (std::size_t d = 0; d < w.size(); ++d) {
    double planes = 0;
    for (std::size_t p = 0; p + d < w.size(); ++p) planes += (d ? 2 : 1) * w[p] * w[p + d];
    const double elevation_pitches =
        (planeOffset_sd[d] - planeOffset_sd[0]) * elevationSd_mm[gate] / latticeElevationPitch_mm;
    if (elevation_pitches > kLatticeReach_pitches) break;
    for (std::size_t n = 0; n < lateralLags.size() && n * lineStep_pitches < kLatticeReach_pitches; ++n)
      for (std::size_t m = 0; m < axialLags.size() && m * gateStep_pitches < kLatticeReach_pitches; ++m)
        variance += planes * (n ? 2 : 1) * lateralLags[n] * (m ? 2 : 1) * axialLags[m] *
                    latticeCorrelation(std::hypot(n * lineStep_pitches, m * gateStep_pitches), elevation_pitches);
  }
  return variance;
}

void FramePlan::planeBeam() {
  using acoustics::kFwhmPerSd;
  const double axialSd_mm = axialFwhm_mm(probe, settings) / kFwhmPerSd;
  // The lattice's own grain counts toward the point-spread function.
  const double latticeVariance_mm2 = latticePitch_mm * latticePitch_mm / 6;
  const auto kernelSd = [&](double total_mm) {
    return std::sqrt(std::max(total_mm * total_mm - latticeVariance_mm2, 0.04 * total_mm * total_mm));
  };
  axialKernel = settings.effects.beam ? halfKernel(kernelSd(axialSd_mm) / gate_mm) : std::vector<double>{1};
  const std::vector<double> axialLags = autocorrelation(axialKernel);

  std::vector<std::vector<double>> lateral(gates);
  for (int g = 0; g < gates; ++g) {
    const double sd_lines =
        kernelSd(lateralFwhm_mm(probe, settings, range_mm(g)) / kFwhmPerSd) / grid.scanlineSpacing_mm(range_mm(g));
    lateral[g] = settings.effects.beam ? halfKernel(std::max(sd_lines, 1e-3)) : std::vector<double>{1};
    lateralRadius.push_back(static_cast<int>(lateral[g].size()) - 1);
    maxLateralRadius = std::max(maxLateralRadius, lateralRadius[g]);
  }
  lateralKernel.assign(std::size_t(gates) * (maxLateralRadius + 1), 0);
  for (int g = 0; g < gates; ++g) {
    std::copy(lateral[g].begin(), lateral[g].end(), lateralKernel.begin() + std::ptrdiff_t(g) * (maxLateralRadius + 1));
    scatterScale.push_back(1 / std::sqrt(speckleVariance(g, axialLags, autocorrelation(lateral[g]))));
  }
  // Peak of the B-spline impulse after the axial kernel.
  const double next = axialKernel.size() > 1 ? axialKernel[1] : 0;
  boundaryScale = 1 / (0.75 * axialKernel[0] + 0.25 * next);
}

}  // namespace insonate
