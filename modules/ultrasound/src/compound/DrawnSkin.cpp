#include "compound/DrawnSkin.h"

#include "model/FramePlan.h"
#include "model/NeedleEchoes.h"

#include <insonate/ultrasound/PointSpread.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate {
namespace {

/// Lattice of frames without compression, in which only the gap changes from point to point.
constexpr double kDrawnStep_mm = 0.5;
/// Engines search for the skin some steps above the face, where tissue moves as at the face.
constexpr double kDrawnAbove_mm = 2;
constexpr Vec3 kAlongProbe{0, 0, 1};

}  // namespace

void DrawnSkin::prepare(const Probe& probe, const ImagingSettings& settings, double maxSteering_deg) {
  const BeamGrid grid(probe, settings);
  origins_.resize(grid.scanlines());
  for (int l = 0; l < grid.scanlines(); ++l) origins_[l] = grid.origin(l);
  strength_.assign(origins_.size(), 1);
  gap_mm_.assign(origins_.size(), 0);
  half_mm_ = probe.width_mm / 2;
  depth_mm_ = settings.depth_mm;
  reach_mm_ = half_mm_ + depth_mm_ * std::tan(maxSteering_deg * std::numbers::pi / 180);
  const SliceLaw slice = sliceLaw(probe, settings.frequency_MHz);
  sliceSd_mm_ = std::max(slice.thickness_mm(0), slice.thickness_mm(depth_mm_)) / acoustics::kFwhmPerSd;
  setLattice({});
}

void DrawnSkin::setLattice(const PlaneDisplacement& displacement) {
  const double step_mm = displacement.empty() ? kDrawnStep_mm : displacement.step_mm;
  // Points of the given lattice remain points, so that its values are not smoothed.
  const auto from = [step_mm](double given_mm, double wanted_mm) {
    return given_mm - step_mm * std::max(0.0, std::ceil((given_mm - wanted_mm) / step_mm));
  };
  drawn_.step_mm = step_mm;
  drawn_.left_mm = from(displacement.left_mm, -reach_mm_);
  drawn_.top_mm = from(displacement.top_mm, -kDrawnAbove_mm);
  drawn_.columns = 1 + static_cast<int>(std::ceil(-2 * drawn_.left_mm / drawn_.step_mm));
  drawn_.rows = 1 + static_cast<int>(std::ceil((depth_mm_ - drawn_.top_mm) / drawn_.step_mm));
  drawn_.restFromDisplayed.resize(std::size_t(drawn_.columns) * drawn_.rows);
  pulledShare_.resize(drawn_.rows);
  for (int r = 0; r < drawn_.rows; ++r) {
    const double range_mm = std::max(drawn_.top_mm + r * drawn_.step_mm, 0.0);
    pulledShare_[r] = tissueRange_mm(range_mm, 1) - range_mm;
  }
}

double DrawnSkin::gapAt(double x_mm) const {
  const auto last = static_cast<double>(gap_mm_.size() - 1);
  const double pitch_mm = 2 * half_mm_ / static_cast<double>(gap_mm_.size());
  const double line = std::clamp((x_mm + half_mm_) / pitch_mm - 0.5, 0.0, last);
  const auto left = static_cast<std::size_t>(line);
  const double share = line - static_cast<double>(left);
  return gap_mm_[left] * (1 - share) + gap_mm_[std::min(left + 1, gap_mm_.size() - 1)] * share;
}

void DrawnSkin::find(const TissueField& field, const Transform& patientFromProbe,
                     const PlaneDisplacement& displacement) {
  for (std::size_t l = 0; l < origins_.size(); ++l) {
    const Contact contact = contactOf(field, patientFromProbe, displacement, origins_[l], kAlongProbe);
    gap_mm_[l] = static_cast<float>(contact.gap_mm);
    strength_[l] = static_cast<float>(contact.strength);
  }
  setLattice(displacement);
  drawn_.lung = displacement.lung;
  for (int c = 0; c < drawn_.columns; ++c) {
    const double x_mm = drawn_.left_mm + c * drawn_.step_mm, gap_mm = gapAt(x_mm);
    for (int r = 0; r < drawn_.rows; ++r) {
      const double z_mm = drawn_.top_mm + r * drawn_.step_mm;
      const double pulled_mm = gap_mm * pulledShare_[r];
      const Vec3 shift = shiftAt(displacement, x_mm, z_mm + pulled_mm);
      drawn_.restFromDisplayed[std::size_t(r) * drawn_.columns + c] = {static_cast<float>(shift.x),
                                                                       static_cast<float>(shift.z + pulled_mm)};
    }
  }
}

Needle DrawnSkin::moved(const Needle& needle, const Transform& patientFromProbe) const {
  const Mat3 probeFromPatient = transposed(patientFromProbe.linear);
  const Vec3 tip_mm = probeFromPatient * (needle.tip_mm - patientFromProbe.offset);
  const Vec3 at_mm =
      visiblePoint_mm(tip_mm, normalized(probeFromPatient * needle.direction), needle.length_mm, sliceSd_mm_);
  const double range_mm = std::max(at_mm.z, 0.0);
  Needle drawn = needle;
  drawn.tip_mm = needle.tip_mm +
                 patientFromProbe.linear * (kAlongProbe * (displayedRange_mm(range_mm, gapAt(at_mm.x)) - range_mm));
  return drawn;
}

}  // namespace insonate
