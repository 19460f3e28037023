#include "needle/NeedleMechanics.h"

#include <algorithm>
#include <cmath>

/// Resistance of a needle from its state: walls, cutting and friction along the needle; entry and track across it.
namespace insonate::haptics {
namespace {

/// Up to this depth a needle can turn about its entry (fulcrum); deeper, its track holds it increasingly (line). The
/// thesis gives no numbers; trainees redirect near the skin.
constexpr double kLineFrom_mm = 10;
/// Length in the tissue from which the entry holds the shaft fully.
constexpr double kFulcrumFull_mm = 3;
constexpr double kFulcrum_Npmm = 0.5;
/// Tissue that is displaced sideways by more than this moves with the needle.
constexpr double kMaxAside_mm = 8;
constexpr double kFriction_Npmm = 0.5;

Vec3 across(Vec3 v, Vec3 axis) {
  return v - axis * dot(v, axis);
}

}  // namespace

void NeedleMechanics::track(const TissueSample& sample, Vec3 tip, Vec3 axis) {
  state_.tenting = false;
  state_.tent_mm = 0;
  for (int wall = 0; wall < kNeedleWallCount; ++wall)
    if (contacts_[wall].active && contacts_[wall].depth_mm > state_.tent_mm) {
      state_.tenting = true;
      state_.tented = kNeedleWalls[wall];
      state_.tent_mm = contacts_[wall].depth_mm;
    }
  state_.onBone = onBone_.active && onBone_.depth_mm > 0;
  state_.in = tissueOf(sample);
  if (state_.inBody && table_.of(state_.in).wall == NeedleWall::None) around_ = state_.in;
  if (!state_.inBody) {
    state_.depth_mm = 0;
    return;
  }
  if (dot(tip - state_.entry_mm, state_.track) < kLineFrom_mm) {
    state_.track = axis;
  } else {
    const Vec3 aside = across(tip - state_.entry_mm, state_.track);
    if (const double off_mm = norm(aside); off_mm > kMaxAside_mm)
      state_.entry_mm = state_.entry_mm + aside * (1 - kMaxAside_mm / off_mm);
  }
  state_.depth_mm = std::max(0.0, dot(tip - state_.entry_mm, state_.track));
  shaft_.reach(state_.depth_mm, table_, state_.in);
}

Vec3 NeedleMechanics::along(Vec3 axis, double speed_mmps, NeedleForce& force) {
  Vec3 sum;
  for (const Contact& contact : contacts_)
    if (contact.active && contact.depth_mm > 0)
      sum = sum - contact.direction * contact.force_N - contact.aside_mm * kAside_Npmm;
  if (onBone_.active) sum = sum - onBone_.direction * onBone_.force_N;
  if (!state_.inBody) return sum;
  const double s_mm = dot(tip_ - state_.entry_mm, state_.track);
  const NeedleTissue& tissue = table_.of(state_.in);
  const ShaftTissue::Sum shaft = shaft_.upTo(s_mm, table_);
  const double part_Npmm = 0.2 * steepest_Npmm_;
  const double cutting_N = cut_.force_N(s_mm, tissue.cutting_N, std::min(tissue.cuttingStiffness_Npmm, part_Npmm));
  const double friction_N =
      friction_.force_N(s_mm, speed_mmps, shaft.slides_N, shaft.holds_N, std::min(kFriction_Npmm, part_Npmm));
  force.viscous_N = axis * (-shaft.viscous_Nspmm * speed_mmps);
  return sum - state_.track * (cutting_N + friction_N) + force.viscous_N;
}

void NeedleMechanics::aside(Vec3 axis, NeedleForce& force) {
  const double s_mm = dot(tip_ - state_.entry_mm, state_.track);
  const double max_Npmm = 0.5 * steepest_Npmm_;
  // Fulcrum: the shaft passes through the entry. Potential k(s) |r|^2 / 2 with r from the shaft to the entry.
  const Vec3 toEntry = across(state_.entry_mm - tip_, axis);
  const double hold = std::clamp(s_mm / kFulcrumFull_mm, 0.0, 1.0);
  const Vec3 fulcrum_N = toEntry * (hold * std::min(kFulcrum_Npmm, max_Npmm));
  force.force_N = force.force_N + fulcrum_N;
  force.torque_Nmm = force.torque_Nmm + cross(axis * dot(state_.entry_mm - tip_, axis), fulcrum_N);
  if (s_mm <= kLineFrom_mm) return;
  // Line: tissue beyond the first 10 mm holds the tip on its track. Potential k(s) |q|^2 / 2; k increases with the
  // length in the tissue.
  const Vec3 off = across(tip_ - state_.entry_mm, state_.track);
  const double lateral_Npmm = shaft_.upTo(s_mm, table_).lateral_Npmm - shaft_.upTo(kLineFrom_mm, table_).lateral_Npmm;
  force.force_N = force.force_N - off * std::clamp(lateral_Npmm, 0.0, max_Npmm);
  const double slope = lateral_Npmm < max_Npmm ? table_.of(state_.in).lateral_Npmm2 : 0;
  force.force_N = force.force_N - state_.track * (0.5 * slope * dot(off, off));
}

NeedleForce NeedleMechanics::resist(Vec3 axis, double speed_mmps) {
  NeedleForce force;
  force.force_N = along(axis, speed_mmps, force);
  state_.axial_N = 0 - dot(force.force_N, axis);  // avoids -0
  if (state_.inBody) aside(axis, force);
  return force;
}

}  // namespace insonate::haptics
