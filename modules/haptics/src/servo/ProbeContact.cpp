#include "servo/ProbeContact.h"

#include "needle/Springs.h"

#include <algorithm>
#include <cmath>

namespace insonate::haptics {
namespace {

/// Patches arrive tens of times a second; the hand feels a gradual change from one to the next over this time.
constexpr double kBlend_s = 0.015;
/// N for each mm/s of the whole face, only while it moves in.
constexpr double kDamping_Nspmm = 0.002;
constexpr double kAlong_Npmm = 0.3;

SkinPatch between(const SkinPatch& a, const SkinPatch& b, double share) {
  SkinPatch mixed = b;
  mixed.skin_mm = a.skin_mm + (b.skin_mm - a.skin_mm) * share;
  mixed.outward = normalized(a.outward + (b.outward - a.outward) * share);
  mixed.stiffness_Npmm = a.stiffness_Npmm + (b.stiffness_Npmm - a.stiffness_Npmm) * share;
  mixed.stiffening_Npmm2 = a.stiffening_Npmm2 + (b.stiffening_Npmm2 - a.stiffening_Npmm2) * share;
  return mixed;
}

}  // namespace

void ProbeContact::take(const LocalModel& model, double step_s) {
  const int count = std::clamp(model.patchCount, 0, static_cast<int>(patches_.size()));
  const double share = count == count_ ? std::clamp(step_s / kBlend_s, 0.0, 1.0) : 1;
  for (int i = 0; i < count; ++i) {
    const bool opposite = dot(patches_[i].outward, model.patches[i].outward) < 0.5;
    patches_[i] = between(patches_[i], model.patches[i], opposite ? 1 : share);
  }
  for (int i = count; i < static_cast<int>(patches_.size()); ++i) touches_[i] = false;
  count_ = count;
}

SkinForce ProbeContact::press(const LocalModel& model, const Transform& patientFromProbe, double steepest_Npmm,
                              double friction, double step_s) noexcept {
  take(model, step_s);
  SkinForce sum;
  for (int i = 0; i < count_; ++i) {
    const SkinPatch& patch = patches_[i];
    const Vec3 point = patientFromProbe * patch.onProbe_mm;
    const double depth_mm = -dot(point - patch.skin_mm, patch.outward);
    if (!(depth_mm > 0)) {
      touches_[i] = false;
      continue;
    }
    const Vec3 foot = point + patch.outward * depth_mm;
    const double speed_mmps = touches_[i] && step_s > 0 ? (depth_mm - depth_mm_[i]) / step_s : 0;
    const Stiffening law{patch.stiffness_Npmm, patch.stiffening_Npmm2, steepest_Npmm / count_};
    const double spring_N = law.force_N(depth_mm);
    // Damping is at most as strong as the spring, so that the force begins at zero.
    const double damping_N = std::clamp(kDamping_Nspmm / count_ * speed_mmps, 0.0, spring_N);
    if (!touches_[i]) anchor_mm_[i] = foot;
    Vec3 along = anchor_mm_[i] - foot;
    along = along - patch.outward * dot(along, patch.outward);
    const double along_Npmm = std::min(kAlong_Npmm, steepest_Npmm) / count_;
    const double max_mm = friction * spring_N / along_Npmm, lag_mm = norm(along);
    if (lag_mm > max_mm) along = along * (max_mm / lag_mm);
    anchor_mm_[i] = foot + along;
    const Vec3 force_N = patch.outward * (spring_N + damping_N) + along * along_Npmm;
    sum.force.force_N = sum.force.force_N + force_N;
    sum.force.torque_Nmm = sum.force.torque_Nmm + cross(point - patientFromProbe.offset, force_N);
    sum.deepest_mm = std::max(sum.deepest_mm, depth_mm);
    depth_mm_[i] = depth_mm;
    touches_[i] = true;
  }
  sum.axial_N = -dot(sum.force.force_N, patientFromProbe.linear.column[2]);
  return sum;
}

}  // namespace insonate::haptics
