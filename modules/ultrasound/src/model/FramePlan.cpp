#include "model/FramePlan.h"

#include "model/Scatterers.h"

#include <insonate/core/Hash.h>
#include <insonate/ultrasound/PointSpread.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace insonate {
namespace {

/// Spacing of 3, 5, 7 and 9 planes in units of the slice's SD, with which the planes, each with its share of a
/// Gaussian's power, have the RMS width of the slice.
constexpr double kPlaneSpacing_sd[] = {1.041, 0.684, 0.517, 0.419};
constexpr double kGatesPerPulse = 2.4;
/// Limits of the scatterers' lattice, in pulses. Scanlines farther apart than its nodes would have independent speckle,
/// which would jump between them: the lattice is as coarse as the scanlines, up to what the pulse permits.
constexpr double kFinestLattice = 0.58, kCoarsestLattice = 0.68;

constexpr double kFaintest = 3e-3;  // relative to the beam's axis, where its kernel ends
constexpr double kCellDepth_mm = 0.4, kCellWidth_mm = 0.4;
constexpr int kMaxKernelRadius = 32;

/// Half of a sampled kernel of unit sum, from a profile by samples from its center, cut off where it is negligible.
template <class Profile>
std::vector<double> halfKernel(const Profile& profile) {
  std::vector<double> half;
  for (int o = 0; o <= kMaxKernelRadius; ++o) half.push_back(profile(o));
  while (half.size() > 1 && half.back() < kFaintest) half.pop_back();
  double sum = -half[0];
  for (const double w : half) sum += 2 * w;
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

/// The correlation of the lattice is a part of the point-spread function: kernels are narrower by it.
double narrowing(double sd_mm, double latticePitch_mm) {
  const double latticeVariance_mm2 = latticePitch_mm * latticePitch_mm / 6;
  return std::sqrt(std::max(1 - latticeVariance_mm2 / (sd_mm * sd_mm), 0.04));
}

/// Half kernels of all gates in rows of equal length.
void tabulate(const std::vector<std::vector<double>>& halves, std::vector<int>& radius, int& maxRadius,
              std::vector<double>& table) {
  for (const std::vector<double>& half : halves) {
    radius.push_back(static_cast<int>(half.size()) - 1);
    maxRadius = std::max(maxRadius, radius.back());
  }
  table.assign(halves.size() * (maxRadius + 1), 0);
  for (std::size_t g = 0; g < halves.size(); ++g)
    std::copy(halves[g].begin(), halves[g].end(), table.begin() + std::ptrdiff_t(g) * (maxRadius + 1));
}

}  // namespace

CubicWeights cubicAt(double t) {
  return {{t * (-0.5 + t * (1 - 0.5 * t)), 1 + t * t * (-2.5 + 1.5 * t), t * (0.5 + t * (2 - 1.5 * t)),
           t * t * (-0.5 + 0.5 * t)}};
}

FramePlan::FramePlan(const Probe& p, const ImagingSettings& s) : probe(p), settings(s), grid(p, s), field(p, s) {
  const double pulse_mm = axialFwhm_mm(p, s);
  lines = grid.scanlines();
  stride = std::max(1, static_cast<int>(pulse_mm / kGatesPerPulse / grid.step_mm()));
  gates = (grid.samples() + stride - 1) / stride;
  gate_mm = stride * grid.step_mm();
  aperture = ApertureRays(p, s, grid, gates, gate_mm);
  // The thesis style computes its reflection from the slope between nodes, which must be closer.
  cellGates = std::clamp(static_cast<int>(kCellDepth_mm / gate_mm + 1e-6), 1, s.look == Look::Thesis ? 4 : 5);
  cellLines = grid.scanlineSpacing_mm(s.depth_mm) * 2 <= kCellWidth_mm ? 2 : 1;
  nodeRows = (gates + cellGates - 1) / cellGates + 1;
  nodeColumns = (lines + cellLines - 1) / cellLines + 1;
  const auto steering_deg =
      static_cast<std::int32_t>(std::lround(probe.shape == ProbeShape::Linear ? s.steering_deg : 0));
  if (steering_deg != 0) specklePattern = hash32(static_cast<std::uint32_t>(steering_deg));
  latticePitch_mm = std::clamp(grid.scanlineSpacing_mm(std::min(s.focus_mm, s.depth_mm)), kFinestLattice * pulse_mm,
                               kCoarsestLattice * pulse_mm);
  latticeElevationPitch_mm = 3 * latticePitch_mm;
  planeElevation();
  planeBeam();
}

void FramePlan::planeElevation() {
  const int planes = settings.elevationPlanes;
  for (int g = 0; g < gates; ++g) elevationSd_mm.push_back(field.sliceSd_mm(range_mm(g)));
  if (planes > 1) planeSpacing_sd = kPlaneSpacing_sd[planes / 2 - 1];
  std::vector<double> power(planes), amplitude(planes);
  // Shares of the slice at the focus of its lens, where it is thin; elsewhere they are similar.
  const double focus_mm = std::min(probe.elevationFocus_mm, settings.depth_mm), sd_mm = field.sliceSd_mm(focus_mm);
  constexpr int kSteps = 400;
  for (int n = -kSteps; n <= kSteps; ++n) {
    const double off_mm = field.sliceReach_mm() * n / kSteps, here = field.elevation(off_mm, focus_mm);
    const double plane = planes > 1 ? std::round(off_mm / sd_mm / planeSpacing_sd) : 0;
    const int p = std::clamp(static_cast<int>(plane) + planes / 2, 0, planes - 1);
    power[p] += here * here, amplitude[p] += here;
  }
  const double allPower = std::accumulate(power.begin(), power.end(), 0.0);
  const double allAmplitude = std::accumulate(amplitude.begin(), amplitude.end(), 0.0);
  for (int p = 0; p < planes; ++p) {
    planeOffset_sd.push_back((p - planes / 2) * planeSpacing_sd);
    scatterWeight.push_back(std::sqrt(power[p] / allPower));
    boundaryWeight.push_back(amplitude[p] / allAmplitude);
  }
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

/// Maximum of a boundary's B-spline after the axial kernel, by samples: the mean over its positions between gates.
double FramePlan::impulsePeak(const std::vector<double>& half) const {
  constexpr int kPlaces = 16;
  const int radius = static_cast<int>(half.size()) - 1;
  const auto spline = [](double off) {
    const double x = std::abs(off);
    return x < 0.5 ? 0.75 - x * x : x < 1.5 ? 0.5 * (1.5 - x) * (1.5 - x) : 0;
  };
  double sum = 0;
  for (int place = 0; place < kPlaces; ++place) {
    const auto atGate = [&](int gate) {
      double value = 0;
      for (int o = -radius; o <= radius; ++o) value += half[std::abs(o)] * spline(gate + o - (place + 0.5) / kPlaces);
      return value;
    };
    double peak = 0;
    for (int m = -stride; m < 2 * stride; ++m) {
      const double gate = (m + 0.5) / stride - 0.5;
      const int before = static_cast<int>(std::floor(gate));
      const CubicWeights w = cubicAt(gate - before);
      double value = 0;
      for (int o = 0; o < 4; ++o) value += w.weight[o] * atGate(before - 1 + o);
      peak = std::max(peak, value);
    }
    sum += peak;
  }
  return sum / kPlaces;
}

/// Half of the axial kernel by gate.
std::vector<std::vector<double>> FramePlan::axialHalves() const {
  if (!settings.effects.beam) return std::vector<std::vector<double>>(gates, {1});
  const auto halfAt = [&](double depth_mm) {
    const double sd_mm = axialFwhm_mm(probe, settings, depth_mm) / acoustics::kFwhmPerSd;
    const double sd_gates = sd_mm * narrowing(sd_mm, latticePitch_mm) / gate_mm;
    return halfKernel([&](int off) { return std::exp(-0.5 * off * off / (sd_gates * sd_gates)); });
  };
  const std::vector<double> atFace = halfAt(0);
  std::vector<std::vector<double>> halves(gates, atFace);
  if (settings.dynamicFilter <= 0) return halves;
  const double peak = impulsePeak(atFace);
  for (int g = 0; g < gates; ++g) {
    halves[g] = halfAt(range_mm(g));
    const double gain = peak / impulsePeak(halves[g]);
    for (double& weight : halves[g]) weight *= gain;
  }
  return halves;
}

void FramePlan::planeBeam() {
  const std::vector<std::vector<double>> axial = axialHalves();
  std::vector<std::vector<double>> lateral(gates);
  for (int g = 0; g < gates; ++g) {
    const double range = range_mm(g);
    const double lateralSd_mm = lateralFwhm_mm(probe, settings, range) / acoustics::kFwhmPerSd;
    const double step_mm = grid.scanlineSpacing_mm(range) / narrowing(lateralSd_mm, latticePitch_mm);
    const auto beam = [&](int off) { return field.lateral(off * step_mm / beamGrowth(settings, range), range); };
    lateral[g] = settings.effects.beam ? halfKernel(beam) : std::vector<double>{1};
  }
  tabulate(axial, axialRadius, maxAxialRadius, axialKernel);
  tabulate(lateral, lateralRadius, maxLateralRadius, lateralKernel);
  for (int g = 0; g < gates; ++g)
    scatterScale.push_back(1 / std::sqrt(speckleVariance(g, autocorrelation(axial[g]), autocorrelation(lateral[g]))));
  boundaryScale = 1 / impulsePeak(axial[0]);
}

}  // namespace insonate
