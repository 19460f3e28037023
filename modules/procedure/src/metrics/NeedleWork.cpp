#include "metrics/NeedleWork.h"

#include <algorithm>
#include <cmath>

namespace insonate::metrics {

void NeedleWork::beginPass(Vec3 hole_mm) {
  hole_mm_ = last_mm_ = hole_mm;
  squares_mm2_ = 0, moments_ = {{Vec3{}, Vec3{}, Vec3{}}}, points_ = 0;
  mark_mm_ = deepest_mm_ = back_mm_ = 0, wentBack_ = false;
}

void NeedleWork::endPass(Vec3 tip_mm) {
  if (reached_) return;
  path_mm_ += norm(tip_mm - last_mm_);
  last_mm_ = tip_mm;
}

void NeedleWork::endAtVein(Vec3 tip_mm) {
  if (reached_) return;
  endPass(tip_mm);
  end_mm_ = tip_mm, reached_ = true;
}

void NeedleWork::follow(Vec3 tip_mm, double depth_mm, bool aspirating) {
  if (reached_) return;
  if (norm(tip_mm - last_mm_) >= kStep_mm) walk(tip_mm);
  advance(depth_mm, aspirating);
  redirect(depth_mm);
}

void NeedleWork::walk(Vec3 tip_mm) {
  path_mm_ += norm(tip_mm - last_mm_);
  last_mm_ = tip_mm;
  const Vec3 from = tip_mm - hole_mm_;
  squares_mm2_ += dot(from, from);
  for (int axis = 0; axis < 3; ++axis) moments_.column[axis] = moments_.column[axis] + from * from[axis];
  ++points_;
}

/// A step forward moves the mark at once, whatever the last motion backward was; backward, the mark follows.
void NeedleWork::advance(double depth_mm, bool aspirating) {
  const double by_mm = depth_mm - mark_mm_;
  if (std::abs(by_mm) < kStep_mm) return;
  mark_mm_ = depth_mm;
  if (by_mm < 0) return;
  advanced_mm_ += by_mm;
  if (aspirating) aspirating_mm_ += by_mm;
}

void NeedleWork::redirect(double depth_mm) {
  if (!wentBack_) {
    deepest_mm_ = std::max(deepest_mm_, depth_mm);
    if (depth_mm > deepest_mm_ - kRedirect_mm) return;
    wentBack_ = true, back_mm_ = depth_mm;
  }
  back_mm_ = std::min(back_mm_, depth_mm);
  if (depth_mm < back_mm_ + kRedirect_mm) return;
  ++redirections_;
  wentBack_ = false, deepest_mm_ = depth_mm;
}

std::optional<double> NeedleWork::inefficiency_percent() const {
  const double straight_mm = norm(end_mm_ - hole_mm_);
  if (!reached_ || straight_mm < kStep_mm) return std::nullopt;
  return 100 * (path_mm_ / straight_mm - 1);
}

/// Mean of |p|^2 - (u.p)^2 over the points p, with u along the straight line.
std::optional<double> NeedleWork::deviation_mm() const {
  const Vec3 line = end_mm_ - hole_mm_;
  if (!reached_ || points_ == 0 || norm(line) < kStep_mm) return std::nullopt;
  const Vec3 u = normalized(line);
  return std::sqrt(std::max(0.0, squares_mm2_ - dot(u, moments_ * u)) / points_);
}

std::optional<double> NeedleWork::aspirating_percent() const {
  if (advanced_mm_ <= 0) return std::nullopt;
  return 100 * aspirating_mm_ / advanced_mm_;
}

}  // namespace insonate::metrics
