#include "model/Contact.h"
#include "model/NeedleEchoes.h"
#include "model/PlaneShift.h"

#include <insonate/ultrasound/PointSpread.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>

namespace insonate {
namespace {

constexpr double kTurn_deg = 180 / std::numbers::pi;
constexpr double kRodStep_gates = 0.75;  // as along a needle
constexpr double kLeastAcross2 = 1e-3;   // beams parallel to a rod have no defined crossing
constexpr double kMinimumSeen = 1e-3;    // relative to the middle of the slice
constexpr double kMargin_mm = 2;         // beside the field of view
/// Largest displacement of tissue by a probe.
constexpr double kDisplaced_mm = 25;
constexpr double kFaintTail = 1e-4;  // end of a tail, relative to the largest echo of its line
constexpr double kLeastRodLoss_dB = 0.01;
/// Spread of a wire's shadow across the scanlines and across the slice: behind a wire, the beam of an aperture of
/// F-number 2 (elevation: 4) comes together within a few millimeters, and much of it passes beside the wire. Our
/// choice.
constexpr double kApertureSd_mm = 1.2, kElevationSd_mm = 0.6;
constexpr int kPieces = 4;       // between two nodes
constexpr int kShadedEvery = 4;  // steps between two shadows; scanlines are wider than a step

double amplitudeOfDecibel(double dB) {
  return std::pow(10.0, dB / 20);
}

double steelReflection() {
  using namespace steel;
  return (kImpedance_MRayl - kTissueImpedance_MRayl) / (kImpedance_MRayl + kTissueImpedance_MRayl);
}

double polymerReflection() {
  return (rods::kPolymerImpedance_MRayl - steel::kTissueImpedance_MRayl) /
         (rods::kPolymerImpedance_MRayl + steel::kTissueImpedance_MRayl);
}

/// Integral of a unit Gaussian from `low` to `high`.
double gaussianBetween(double low_sd, double high_sd) {
  return 0.5 * (std::erf(high_sd / std::numbers::sqrt2) - std::erf(low_sd / std::numbers::sqrt2));
}

/// Wall of a rod: distance from the axis (negative: toward the probe), and share of the amplitude that it reflects.
struct Surface {
  double offset_mm, reflection;
};

struct Surfaces {
  std::array<Surface, 4> all{};
  int count = 0;
};

/// A coil reflects everything on its near side. Each wall of a catheter has two surfaces.
Surfaces surfacesOf(const FlexibleRod& rod) {
  Surfaces walls;
  const double outer = rod.radius_mm, inner = rod.innerRadius_mm;
  if (rod.material == RodMaterial::SteelCoil) {
    walls.all[walls.count++] = {-outer, steelReflection()};
    return walls;
  }
  const double r = polymerReflection();
  double left = 1;  // amplitude there and back, less the reflections on the way
  const auto add = [&](double offset_mm) {
    walls.all[walls.count++] = {offset_mm, r * left};
    left *= 1 - r * r;
  };
  add(-outer);
  if (inner > 0) add(-inner), add(inner);
  add(outer);
  return walls;
}

/// Point on the smooth curve (Catmull-Rom) through the nodes, from node i - 1 (t = 0) to node i (t = 1).
Vec3 curveThrough(std::span<const Vec3> nodes_mm, std::size_t i, double t) {
  const Vec3 p1 = nodes_mm[i - 1], p2 = nodes_mm[i];
  const Vec3 p0 = i > 1 ? nodes_mm[i - 2] : p1, p3 = i + 1 < nodes_mm.size() ? nodes_mm[i + 1] : p2;
  return 0.5 * (2 * p1 + (p2 - p0) * t + (2 * p0 - 5 * p1 + 4 * p2 - p3) * (t * t) +
                (3 * p1 - p0 - 3 * p2 + p3) * (t * t * t));
}

}  // namespace

/// A short piece of a rod in the probe frame.
struct NeedleEchoes::RodStep {
  Vec3 axis_mm, direction;
  double length_mm = 0, radius_mm = 0;
  Surfaces walls;
  bool isCoil = false;
};

Vec3 NeedleEchoes::shown_mm(Vec3 rest_mm, const TissueField& field, const Transform& patientFromProbe,
                            const PlaneDisplacement& displacement) const {
  const BeamGrid& grid = plan_->grid;
  const Vec3 atRest_mm = transposed(patientFromProbe.linear) * (rest_mm - patientFromProbe.offset);
  Vec3 seen_mm = displacement.empty() ? atRest_mm : seenFromRest(displacement, atRest_mm);
  seen_mm.y = atRest_mm.y;
  if (!plan_->settings.conformingContact) return seen_mm;
  const auto location = grid.locate(seen_mm.x, seen_mm.z);
  const double line = std::clamp(location.scanline, 0.0, plan_->lines - 1.0);
  const double range_mm = std::max(grid.range_mm(location.sample), 0.0);
  const Vec3 beam = grid.direction(line);
  const double gap_mm = contactOf(field, patientFromProbe, displacement, grid.origin(line), beam).gap_mm;
  return seen_mm + beam * (displayedRange_mm(range_mm, gap_mm) - range_mm);
}

void NeedleEchoes::echoRod(const FlexibleRod& rod, const Transform& patientFromProbe, const TissueField& field,
                           const PlaneDisplacement& displacement) {
  const FramePlan& plan = *plan_;
  const BeamGrid& grid = plan.grid;
  const Transform probeFromPatient{transposed(patientFromProbe.linear),
                                   -(transposed(patientFromProbe.linear) * patientFromProbe.offset)};
  const double reach_mm = plan.field.sliceReach_mm(), step_mm = kRodStep_gates * plan.gate_mm;
  const auto shownAt = [&](Vec3 patient_mm) { return shown_mm(patient_mm, field, patientFromProbe, displacement); };
  const auto isWithin = [&](Vec3 p_mm, double margin_mm) {
    return std::abs(p_mm.y) < reach_mm + kMargin_mm && p_mm.x > grid.minLateral_mm() - margin_mm &&
           p_mm.x < grid.maxLateral_mm() + margin_mm && p_mm.z > grid.minAxial_mm() - margin_mm &&
           p_mm.z < grid.maxAxial_mm() + margin_mm;
  };
  const auto isNear = [&](Vec3 p_mm) { return isWithin(p_mm, kMargin_mm); };
  // A probe compresses tissue by up to 20 mm: at rest, tissue of the image then lies beside the image.
  const double rest_mm = displacement.empty() ? kMargin_mm : kMargin_mm + kDisplaced_mm;
  RodStep step{.axis_mm = {},
               .direction = {},
               .length_mm = step_mm,
               .radius_mm = rod.radius_mm,
               .walls = surfacesOf(rod),
               .isCoil = rod.material == RodMaterial::SteelCoil};
  double behind_mm = 0.5 * step_mm;  // position of the next step on the present piece
  int shaded = 0;
  const auto walk = [&](Vec3 from_mm, Vec3 to_mm) {
    const Vec3 along = to_mm - from_mm;
    const double length_mm = norm(along);
    if (!(length_mm > 0)) return;
    step.direction = along / length_mm;
    for (; behind_mm < length_mm; behind_mm += step_mm) {
      step.axis_mm = from_mm + step.direction * behind_mm;
      if (!isNear(step.axis_mm) || std::abs(step.axis_mm.y) > reach_mm) continue;
      if (plan.settings.effects.reflection) echoRodStep(step);
      if (step.isCoil && plan.settings.effects.transmission && shaded++ % kShadedEvery == 0) shadeRodStep(step);
    }
    behind_mm -= length_mm;
  };
  for (std::size_t i = 1; i < rod.nodes_mm.size(); ++i) {
    const Vec3 rest0_mm = probeFromPatient * rod.nodes_mm[i - 1], rest1_mm = probeFromPatient * rod.nodes_mm[i];
    if (!isWithin(rest0_mm, rest_mm) && !isWithin(rest1_mm, rest_mm) && norm(rest1_mm - rest0_mm) < 2 * kMargin_mm)
      continue;
    Vec3 from_mm = shownAt(rod.nodes_mm[i - 1]);
    for (int piece = 1; piece <= kPieces; ++piece) {
      const Vec3 to_mm = shownAt(curveThrough(rod.nodes_mm, i, static_cast<double>(piece) / kPieces));
      walk(from_mm, to_mm);
      from_mm = to_mm;
    }
  }
}

/// A cylinder, as a piece of a needle's shaft (see echoShaft()), for each of its walls.
void NeedleEchoes::echoRodStep(const RodStep& step) {
  const FramePlan& plan = *plan_;
  const BeamGrid& grid = plan.grid;
  const double wavenumber = 2 * std::numbers::pi * plan.settings.frequency_MHz / kSoundSpeed_mmPerUs;
  const Vec3 beam = grid.direction(grid.locate(step.axis_mm.x, step.axis_mm.z).scanline);
  const double along = dot(beam, step.direction);
  const Vec3 across = beam - step.direction * along;
  const double sine = norm(across);
  const Vec3 away = sine * sine > kLeastAcross2 ? across / sine : Vec3{};
  const double tilt_deg = std::asin(std::min(std::abs(along), 1.0)) * kTurn_deg;
  const double tilt_dB = step.isCoil ? std::min(rods::kCoilTiltLoss_dBpdeg * tilt_deg, rods::kCoilMaxTiltLoss_dB)
                                     : steel::kTiltLoss_dBpdeg * tilt_deg;
  const double gain = amplitudeOfDecibel(acoustics::kReflectorGain_dB - tilt_dB) * plan.boundaryScale;
  for (int w = 0; w < step.walls.count; ++w) {
    const Surface& wall = step.walls.all[w];
    const Vec3 surface = step.axis_mm + away * wall.offset_mm;
    const auto at = grid.locate(surface.x, surface.z);
    const double gate = (at.sample + 0.5) / plan.stride - 0.5;
    if (gate < -1 || gate > plan.gates || at.scanline < -1 || at.scanline > plan.lines) continue;
    const double range_mm = plan.range_mm(gate);
    const double seen = plan.field.elevation(surface.y, range_mm);
    if (seen < kMinimumSeen) continue;
    const double strip_mm = std::sqrt(std::numbers::pi * std::abs(wall.offset_mm) / wavenumber);
    const double slice = std::min(1.0, strip_mm / plan.field.sliceIntegral_mm(range_mm)) * seen;
    const double steps = step.length_mm / std::max(grid.scanlineSpacing_mm(range_mm), 1e-3);
    add(at.scanline, gate, gain * wall.reflection * slice * steps, std::nullopt, step.isCoil ? &tail_ : nullptr);
  }
}

/// A coil covers a part of the beam of the scanlines that cross it, as a needle does (see castShadow()).
void NeedleEchoes::shadeRodStep(const RodStep& step) {
  const FramePlan& plan = *plan_;
  const BeamGrid& grid = plan.grid;
  const auto at = grid.locate(step.axis_mm.x, step.axis_mm.z);
  const double gate = (at.sample + 0.5) / plan.stride - 0.5;
  if (gate < 0 || gate >= plan.gates) return;
  const double range_mm = plan.range_mm(gate), spacing_mm = std::max(grid.scanlineSpacing_mm(range_mm), 1e-3);
  const double box = 1 / std::sqrt(12.0);  // SD of a box one wide
  const double slice_mm = plan.elevationSd_mm[static_cast<int>(gate)];
  const double plane_mm = slice_mm * (plan.planeSpacing_sd > 0 ? plan.planeSpacing_sd * box : 1);
  const Vec3 beam = grid.direction(std::clamp(at.scanline, 0.0, plan.lines - 1.0));
  Vec3 between = cross(beam, step.direction);
  between = norm(between) > 1e-6 ? normalized(between) : Vec3{0, 1, 0};
  const double lateral = std::hypot(between.x, between.z);
  const double sd_mm =
      std::hypot(std::max(plane_mm, kElevationSd_mm) * between.y, std::max(spacing_mm * box, kApertureSd_mm) * lateral);
  const int reach = 1 + static_cast<int>((step.radius_mm + 2 * kApertureSd_mm) * lateral / spacing_mm);
  const double passes = 1 - steelReflection() * steelReflection();
  const int middle = static_cast<int>(std::lround(at.scanline));
  for (int plane = 0; plane < plan.settings.elevationPlanes; ++plane)
    for (int line = std::max(middle - reach, 0); line <= std::min(middle + reach, plan.lines - 1); ++line) {
      // Distance between beam and axis; a rod along the scanlines' plane passes each of them in the middle.
      const double beside_mm = (line - at.scanline) * spacing_mm * lateral;
      const double distance_mm =
          std::hypot((plan.planeOffset_sd[plane] * slice_mm - step.axis_mm.y) * between.y, beside_mm);
      const double covered =
          gaussianBetween((distance_mm - step.radius_mm) / sd_mm, (distance_mm + step.radius_mm) / sd_mm);
      const double loss_dB = -20 * std::log10(1 - covered * (1 - passes * passes));
      const std::size_t cell = plane * paddedLines_ + line;
      if (loss_dB < kLeastRodLoss_dB || loss_dB <= loss_dB_[cell]) continue;
      const auto onset = static_cast<float>(gate);
      onset_gate_[cell] = loss_dB_[cell] > 0 ? std::min(onset_gate_[cell], onset) : onset;
      loss_dB_[cell] = static_cast<float>(loss_dB);
      present_ = true;
    }
}

void NeedleEchoes::addTails() {
  const FramePlan& plan = *plan_;
  const auto decay = static_cast<float>(amplitudeOfDecibel(-rods::kTailDecay_dBpmm * plan.gate_mm));
  // The tail has bands, as from echoes between turns of the coil: 1 + cos of the distance behind the echo.
  const std::complex<float> turn =
      std::polar(decay, static_cast<float>(2 * std::numbers::pi * plan.gate_mm / rods::kTailBand_mm));
  const int longest = static_cast<int>(rods::kTail_mm / plan.gate_mm);
  for (int l = 0; l < plan.lines; ++l) {
    const int first = tailFirst_[l];
    if (first >= plan.gates) continue;
    float* coil = tail_.data() + std::size_t(l) * plan.gates;
    float* amplitude = amplitude_.data() + std::size_t(l) * plan.gates;
    float ringing = 0, largest = 0;
    std::complex<float> band = 0;
    int last = first;  // gate of the last echo
    for (int g = first; g < plan.gates && g - last < longest; ++g) {
      if (coil[g] > 0) last = g;
      largest = std::max(largest, coil[g]);
      if (plan.settings.effects.reverberation && ringing > static_cast<float>(kFaintTail) * largest) {
        amplitude[g] += static_cast<float>(rods::kTailShare) * std::max(ringing + band.real(), 0.0F);
        lines_[l].end = std::max(lines_[l].end, g + 1);
      }
      ringing = ringing * decay + coil[g];
      band = band * turn + coil[g];
    }
    std::fill(coil + first, coil + plan.gates, 0.0F);
    tailFirst_[l] = plan.gates;
  }
}

}  // namespace insonate
