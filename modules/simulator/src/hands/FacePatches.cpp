#include "hands/FacePatches.h"

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

/// The face's ends are rounded off.
constexpr double kShareOfFace = 0.9;
constexpr double kReach_mm = 30;
constexpr double kMaxHigher_mm = 4;
/// A smaller indentation does not determine a stiffness.
constexpr double kLeast_mm = 0.3, kLeast_N = 0.02;
/// A model that has not converged may give many times the force.
constexpr double kMaxUnsettled_N = 6;

Vec3 pointOfFace(const ProbeFace& face, int patch) {
  const double x = (patch - 1) * 0.5 * kShareOfFace * face.width_mm, r = face.radius_mm;
  return {x, 0, r > std::abs(x) ? std::sqrt(r * r - x * x) - r : 0};
}

}  // namespace

void FacePatches::show(const SkinSurface& skin, const ProbeFace& face, const Transform& patientFromProbe,
                       LocalModel& model) const {
  const Vec3 away = -patientFromProbe.linear.column[2];
  model.patchCount = kCount;
  for (int i = 0; i < kCount; ++i) {
    SkinPatch& patch = model.patches[i];
    patch.onProbe_mm = pointOfFace(face, i);
    const Vec3 point = patientFromProbe * patch.onProbe_mm;
    const auto there = skin.along(point, away, kReach_mm);
    // A patch outside the body gives no force; it stays in the list, so that the others keep their indices.
    patch.outward = there ? skin.normal(*there, away) : away;
    patch.skin_mm = there ? *there + patch.outward * higher_mm_ : point - away * kReach_mm;
    patch.stiffness_Npmm = there ? law_.k1_Npmm : 0;
    patch.stiffening_Npmm2 = there ? law_.k2_Npmm2 : 0;
  }
}

void FacePatches::learn(const SkinSurface& skin, const ProbeFace& face, const Transform& patientFromProbe,
                        const LiveDeformation& press) {
  const double in_mm = press.indentation_mm, force_N = press.force_N;
  if (!(in_mm > kLeast_mm) || !(force_N > kLeast_N) || (!press.settled && force_N > kMaxUnsettled_N)) return;
  LocalModel model;
  show(skin, face, patientFromProbe, model);
  std::array<double, kCount> depth_mm{}, along{};
  double deepest_mm = -kReach_mm;
  for (int i = 0; i < kCount; ++i) {
    const SkinPatch& patch = model.patches[i];
    depth_mm[i] = -dot(patientFromProbe * patch.onProbe_mm - patch.skin_mm, patch.outward) - higher_mm_;
    along[i] = std::max(-dot(patch.outward, patientFromProbe.linear.column[2]), 0.1);
    deepest_mm = std::max(deepest_mm, depth_mm[i]);
  }
  higher_mm_ = std::clamp(in_mm - deepest_mm, -kMaxHigher_mm, kMaxHigher_mm);

  const double moved_mm = in_mm - before_mm_;
  if (before_mm_ > kLeast_mm && std::abs(moved_mm) > kLeast_mm)
    steeper_ = std::clamp((force_N - before_N_) / moved_mm * in_mm / force_N, 1.0, 2.0);
  if (before_mm_ <= kLeast_mm || std::abs(moved_mm) > kLeast_mm) before_mm_ = in_mm, before_N_ = force_N;

  // k1 sum(d) + k2 sum(d^2) is the present force, k1 n + 2 k2 sum(d) its slope, both along the probe's axis.
  double touching = 0, sum_mm = 0, squares_mm2 = 0;
  for (int i = 0; i < kCount; ++i) {
    const double d = depth_mm[i] + higher_mm_;
    if (d <= 0) continue;
    touching += along[i];
    sum_mm += d * along[i];
    squares_mm2 += d * d * along[i];
  }
  if (sum_mm <= 0) return;
  const double slope_Npmm = steeper_ * force_N / in_mm;
  const double determinant = 2 * sum_mm * sum_mm - touching * squares_mm2;
  const double k2 = determinant > 1e-9 ? (slope_Npmm * sum_mm - touching * force_N) / determinant : 0;
  law_.k2_Npmm2 = std::clamp(k2, 0.0, force_N / squares_mm2);
  law_.k1_Npmm = (force_N - law_.k2_Npmm2 * squares_mm2) / sum_mm;
}

}  // namespace insonate
