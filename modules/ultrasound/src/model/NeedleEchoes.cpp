#include "model/NeedleEchoes.h"

#include "model/Contact.h"

#include <insonate/ultrasound/PointSpread.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kLeastSine2 = 1e-3;     // beams parallel to the shaft have no defined crossing
constexpr double kMinimumWeight = 1e-3;  // relative to the middle of the slice
constexpr double kStep_gates = 0.75;     // B-splines one gate wide have a constant sum
constexpr double kLeastSpacing_mm = 1e-3, kLeastRing = 0.2, kLeastLoss_dB = 0.01;
constexpr double kBeside_mm = 2;  // margin beside the field of view for echoes that extend into it

double fromDecibel(double dB) {
  return std::pow(10.0, dB / 20);
}

double reflection() {
  using namespace steel;
  return (kImpedance_MRayl - kTissueImpedance_MRayl) / (kImpedance_MRayl + kTissueImpedance_MRayl);
}

/// Integral of a unit Gaussian from the left.
double gaussianBefore(double x_sd) {
  return 0.5 * std::erfc(-x_sd / std::numbers::sqrt2);
}

struct Interval {
  double low, high;
};

/// Cuts the interval of s to low <= start + s * slope <= high.
void clip(double start, double slope, double low, double high, Interval& s) {
  if (std::abs(slope) < 1e-12) {
    if (start < low || start > high) s = {0, 0};
    return;
  }
  const double a = (low - start) / slope, b = (high - start) / slope;
  s = {std::max(s.low, std::min(a, b)), std::min(s.high, std::max(a, b))};
}

}  // namespace

Vec3 visiblePoint_mm(Vec3 tip_mm, Vec3 direction, double length_mm, double sliceSd_mm) {
  constexpr double kStep_mm = 0.5, kAroundTip_mm = 2;
  double sum = 1e-30, behind_mm = 0;  // visible echoes, weighted toward the tip
  for (double s = 0; s <= length_mm; s += kStep_mm) {
    const double off_sd = (tip_mm - direction * s).y / sliceSd_mm;
    const double seen = std::exp(-0.5 * off_sd * off_sd - s / kAroundTip_mm);
    sum += seen, behind_mm += seen * s;
  }
  return tip_mm - direction * (behind_mm / sum);
}

struct NeedleEchoes::Pose {
  Vec3 tip_mm, direction;
  Vec3 opening, face;  ///< unit vectors of the bevel: its opening direction across the shaft, and the normal of its
                       ///< face
  double radius_mm, length_mm, bevelLength_mm;

  Pose(const Needle& needle, const Transform& patientFromProbe) {
    const Mat3 probeFromPatient = transposed(patientFromProbe.linear);
    const double angle = steel::kBevel_deg / kDegrees;
    tip_mm = probeFromPatient * (needle.tip_mm - patientFromProbe.offset);
    direction = normalized(probeFromPatient * needle.direction);
    const Vec3 faces = probeFromPatient * needle.bevelNormal;
    opening = normalized(faces - direction * dot(faces, direction));
    face = std::cos(angle) * opening + std::sin(angle) * direction;
    radius_mm = needle.radius_mm, length_mm = needle.length_mm;
    bevelLength_mm = 2 * radius_mm / std::tan(angle);
  }
  /// Point on the axis, `behind_mm` from the tip.
  Vec3 at(double behind_mm) const { return tip_mm - direction * behind_mm; }
};

NeedleEchoes::NeedleEchoes(const FramePlan& plan) : plan_(&plan) {
  amplitude_.resize(std::size_t(plan.lines) * plan.gates);
  lines_.resize(plan.lines);
  tail_.resize(amplitude_.size());
  tailFirst_.assign(plan.lines, plan.gates);
  constexpr std::size_t kVector = 32;
  paddedLines_ = (plan.lines + kVector - 1) / kVector * kVector;
  onset_gate_.resize(plan.settings.elevationPlanes * paddedLines_);
  loss_dB_.resize(onset_gate_.size());
}

void NeedleEchoes::place(const Instruments& instruments, const TissueField& field, const Transform& patientFromProbe,
                         const PlaneDisplacement& displacement) {
  if (present_) {
    for (int l = 0; l < plan_->lines; ++l) {
      float* amplitude = amplitude_.data() + std::size_t(l) * plan_->gates;
      std::fill(amplitude + lines_[l].first, amplitude + lines_[l].end, 0.0F);
      lines_[l] = {};
    }
    std::fill(loss_dB_.begin(), loss_dB_.end(), 0.0F);
  }
  present_ = false;
  if (instruments.needle) placeNeedle(*instruments.needle, field, patientFromProbe, displacement);
  for (const FlexibleRod& rod : instruments.rods) echoRod(rod, patientFromProbe, field, displacement);
  if (!instruments.rods.empty()) addTails();
  if (!plan_->settings.effects.scattering) return;
  for (const Bubble& bubble : instruments.bubbles)
    echoBubble(bubble, shown_mm(bubble.position_mm, field, patientFromProbe, displacement));
}

/// The kernels of the beam, over the B-splines of add(), make a peak of the bubble's amplitude.
void NeedleEchoes::echoBubble(const Bubble& bubble, Vec3 shown_mm) {
  const FramePlan& plan = *plan_;
  const auto at = plan.grid.locate(shown_mm.x, shown_mm.z);
  const double gate = (at.sample + 0.5) / plan.stride - 0.5;
  if (gate < 0 || gate > plan.gates - 1 || at.scanline < 0 || at.scanline > plan.lines - 1) return;
  const double seen = plan.field.elevation(shown_mm.y, plan.range_mm(gate));
  if (seen < kMinimumWeight) return;
  const auto peakOf = [](const double* half, int radius) { return 0.75 * half[0] + (radius > 0 ? 0.25 * half[1] : 0); };
  const auto g = static_cast<std::size_t>(std::lround(gate));
  const double axial = peakOf(plan.axialKernel.data() + g * (plan.maxAxialRadius + 1), plan.axialRadius[g]);
  const double lateral = peakOf(plan.lateralKernel.data() + g * (plan.maxLateralRadius + 1), plan.lateralRadius[g]);
  add(at.scanline, gate, bubble.amplitude * seen / (axial * lateral), std::nullopt);
}

void NeedleEchoes::placeNeedle(const Needle& needle, const TissueField& field, const Transform& patientFromProbe,
                               const PlaneDisplacement& displacement) {
  Pose pose(needle, patientFromProbe);
  if (plan_->settings.conformingContact)
    pose.tip_mm = pose.tip_mm + drawn_mm(pose, field, patientFromProbe, displacement);
  if (plan_->settings.effects.reflection) echoShaft(pose);
  if (!plan_->settings.effects.transmission) return;
  for (int plane = 0; plane < plan_->settings.elevationPlanes; ++plane)
    for (int line = 0; line < plan_->lines; ++line) castShadow(pose, plane, line);
}

Vec3 NeedleEchoes::drawn_mm(const Pose& needle, const TissueField& field, const Transform& patientFromProbe,
                            const PlaneDisplacement& displacement) const {
  const BeamGrid& grid = plan_->grid;
  const double slice_mm = *std::max_element(plan_->elevationSd_mm.begin(), plan_->elevationSd_mm.end());
  const Vec3 at_mm = visiblePoint_mm(needle.tip_mm, needle.direction, needle.length_mm, slice_mm);
  const auto location = grid.locate(at_mm.x, at_mm.z);
  const double line = std::clamp(location.scanline, 0.0, plan_->lines - 1.0);
  const double range_mm = std::max(grid.range_mm(location.sample), 0.0);
  const Vec3 beam = grid.direction(line);
  const double gap_mm = contactOf(field, patientFromProbe, displacement, grid.origin(line), beam).gap_mm;
  return beam * (displayedRange_mm(range_mm, gap_mm) - range_mm);
}

void NeedleEchoes::add(double scanline, double gate, double amplitude, std::optional<float> ring_gates,
                       std::vector<float>* tail) {
  const int l0 = static_cast<int>(std::lround(scanline)), g0 = static_cast<int>(std::lround(gate));
  const auto spline = [](double off, int k) {
    return k == 0 ? 0.75 - off * off : 0.5 * (0.5 + k * off) * (0.5 + k * off);
  };
  for (int l = std::max(l0 - 1, 0); l <= std::min(l0 + 1, plan_->lines - 1); ++l) {
    const double share = amplitude * spline(scanline - l0, l - l0);
    Line& line = lines_[l];
    const int first = std::max(g0 - 1, 0), last = std::min(g0 + 1, plan_->gates - 1);
    if (first > last) continue;
    float* at = amplitude_.data() + std::size_t(l) * plan_->gates;
    for (int g = first; g <= last; ++g) at[g] += static_cast<float>(share * spline(gate - g0, g - g0));
    line.first = line.first < line.end ? std::min(line.first, first) : first;
    line.end = std::max(line.end, last + 1);
    if (ring_gates) line.ring_gates = *ring_gates;
    present_ = true;
    if (!tail) continue;
    float* behind = tail->data() + std::size_t(l) * plan_->gates;
    for (int g = first; g <= last; ++g) behind[g] += static_cast<float>(share * spline(gate - g0, g - g0));
    tailFirst_[l] = std::min(tailFirst_[l], first);
  }
}

/// Every step of the shaft is a cylinder that echoes from a line on its near side.
void NeedleEchoes::echoShaft(const Pose& needle) {
  const FramePlan& plan = *plan_;
  const BeamGrid& grid = plan.grid;
  const double wavenumber = 2 * std::numbers::pi * plan.settings.frequency_MHz / kSoundSpeed_mmPerUs;
  // Over a cylinder of radius a the echo loses phase as exp(i k y^2 / a): it is as strong as that of a strip of width
  // sqrt(pi a / k).
  const double strip_mm = std::sqrt(std::numbers::pi * needle.radius_mm / wavenumber);
  const double echo = fromDecibel(acoustics::kReflectorGain_dB) * reflection() * plan.boundaryScale;
  const double inner_mm = 2 * needle.radius_mm * (1 - 2 * steel::kWallShare);
  const double walls_mm = 4 * needle.radius_mm * steel::kWallShare * kSoundSpeed_mmPerUs / steel::kSpeed_mmPerUs;
  const double reach_mm = plan.field.sliceReach_mm();
  Interval s{0, needle.length_mm};
  clip(needle.tip_mm.x, -needle.direction.x, grid.minLateral_mm() - kBeside_mm, grid.maxLateral_mm() + kBeside_mm, s);
  clip(needle.tip_mm.z, -needle.direction.z, grid.minAxial_mm() - kBeside_mm, grid.maxAxial_mm() + kBeside_mm, s);
  clip(needle.tip_mm.y, -needle.direction.y, -reach_mm, reach_mm, s);

  const double step_mm = kStep_gates * plan.gate_mm;
  for (double n = std::ceil(s.low / step_mm); (n + 0.5) * step_mm < s.high; ++n) {
    const double behind_mm = (n + 0.5) * step_mm;
    const double fromTip = std::min(behind_mm / needle.bevelLength_mm, 1.0);
    const Vec3 axis = needle.at(behind_mm);
    const Vec3 beam = grid.direction(grid.locate(axis.x, axis.z).scanline);
    const double along = dot(beam, needle.direction);
    const Vec3 across = beam - needle.direction * along;
    const double sine = norm(across);
    const Vec3 away = sine * sine > kLeastSine2 ? across / sine : Vec3{};
    // A bevel toward the probe removes the near side of the shaft; a bevel away from it leaves the shaft unchanged.
    const double onFace = fromTip < 1 ? std::max(-dot(away, needle.opening), 0.0) : 0;
    const Vec3 surface = axis - away * (needle.radius_mm * (1 - onFace * (1 - fromTip)));
    const auto at = grid.locate(surface.x, surface.z);
    const double gate = (at.sample + 0.5) / plan.stride - 0.5;
    if (gate < -1 || gate > plan.gates || at.scanline < -1 || at.scanline > plan.lines) continue;
    const double range_mm = plan.range_mm(gate);
    const double seen = plan.field.elevation(surface.y, range_mm);
    if (seen < kMinimumWeight) continue;
    const double slice = std::min(1.0, strip_mm / plan.field.sliceIntegral_mm(range_mm)) * seen;

    const double shaft_deg = std::asin(std::min(std::abs(along), 1.0)) * kDegrees;
    const double face_deg = std::acos(std::clamp(-dot(beam, needle.face), 0.0, 1.0)) * kDegrees;
    const double surface_dB = -steel::kTiltLoss_dBpdeg * (shaft_deg + onFace * (face_deg - shaft_deg));
    const double tip_dB = steel::kTipGain_dB - std::min(steel::kTiltLoss_dBpdeg * shaft_deg, steel::kTipTiltLoss_dB);
    const double gain_dB =
        surface_dB + (tip_dB - surface_dB) * std::exp(-behind_mm * behind_mm / (steel::kTip_mm * steel::kTip_mm));

    const double steps = step_mm / std::max(grid.scanlineSpacing_mm(range_mm), kLeastSpacing_mm);
    // Path lengths through a layer differ by twice its thickness times the cosine of incidence.
    const double ring_mm = plan.settings.effects.reverberation ? (inner_mm + walls_mm) * std::max(sine, kLeastRing) : 0;
    add(at.scanline, gate, echo * slice * fromDecibel(gain_dB) * steps, static_cast<float>(ring_mm / plan.gate_mm));
  }
}

/// A scanline of a plane represents the region up to halfway to its neighbors, of which the needle covers a part.
void NeedleEchoes::castShadow(const Pose& needle, int plane, int line) {
  const FramePlan& plan = *plan_;
  const Vec3 beam = plan.grid.direction(line), origin = plan.grid.origin(line);
  const double cosine = dot(beam, needle.direction), sine2 = std::max(1 - cosine * cosine, kLeastSine2);
  double behind_mm = 0, range_mm = 0, elevation_mm = 0, slice_mm = 0;
  // Planes diverge with depth: starts where the central plane meets the needle.
  for (int pass = 0; pass < 2; ++pass) {
    const Vec3 w = needle.tip_mm - origin - Vec3{0, elevation_mm, 0};
    const double alongNeedle = dot(w, needle.direction), alongBeam = dot(w, beam);
    behind_mm = std::clamp((alongNeedle - cosine * alongBeam) / sine2, 0.0, needle.length_mm);
    range_mm = alongBeam - behind_mm * cosine;
    const int gate = std::clamp(static_cast<int>(range_mm / plan.gate_mm), 0, plan.gates - 1);
    slice_mm = plan.elevationSd_mm[gate];
    elevation_mm = plan.planeOffset_sd[plane] * slice_mm;
  }
  if (range_mm <= 0 || range_mm > plan.settings.depth_mm + needle.radius_mm) return;
  const Vec3 away = needle.at(behind_mm) - origin - Vec3{0, elevation_mm, 0} - beam * range_mm;
  const double distance_mm = norm(away);
  Vec3 between = cross(beam, needle.direction);
  between = norm(between) > 1e-6 ? normalized(between) : Vec3{0, 1, 0};
  const double box = 1 / std::sqrt(12.0);  // SD of a box one wide
  const double plane_mm = slice_mm * (plan.planeSpacing_sd > 0 ? plan.planeSpacing_sd * box : 1);
  const double line_mm = plan.grid.scanlineSpacing_mm(range_mm) * box;
  const double sd_mm = std::hypot(plane_mm * between.y, line_mm * std::hypot(between.x, between.z));
  const double covered = gaussianBefore((distance_mm + needle.radius_mm) / sd_mm) -
                         gaussianBefore((distance_mm - needle.radius_mm) / sd_mm);
  const double whole = std::min(behind_mm / needle.bevelLength_mm, 1.0);
  const double passes = 1 - reflection() * reflection();  // once for each wall
  const double left = 1 - covered * whole * (1 - passes * passes);
  const double chord_mm =
      std::sqrt(std::max(needle.radius_mm * needle.radius_mm - distance_mm * distance_mm, 0.0) / sine2);
  const double loss_dB = -20 * std::log10(left);
  if (loss_dB < kLeastLoss_dB) return;
  const std::size_t at = plane * paddedLines_ + line;
  onset_gate_[at] = static_cast<float>((range_mm - chord_mm * whole) / plan.gate_mm - 0.5);
  loss_dB_[at] = static_cast<float>(loss_dB);
  present_ = true;
}

}  // namespace insonate
