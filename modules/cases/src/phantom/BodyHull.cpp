#include "BodyHull.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate {
namespace {

constexpr double kFullTurn = 2 * std::numbers::pi;
constexpr double kEnclose_mm = 6;  ///< each slice's hull also contains structures of slices within this distance
constexpr double kSmooth_mm = 5;   ///< standard deviation of the smoothing after that

}  // namespace

BodyHull::BodyHull(const LabelMap& structures, double grow_mm) : slices_(structures.geometry.size[2]) {
  measure(structures);
  fillGaps();
  smooth(structures.geometry.spacing_mm.z);
  makeRadii(grow_mm);
}

void BodyHull::measure(const LabelMap& m) {
  const VolumeGeometry& g = m.geometry;
  // All slices have the same center, so that directions can be compared between them.
  double sumX = 0, sumY = 0, count = 0;
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i)
        if (m.at(i, j, k)) sumX += i, sumY += j, ++count;
  const double cx = sumX / count * g.spacing_mm.x, cy = sumY / count * g.spacing_mm.y;
  for (int k = 0; k < g.size[2]; ++k) {
    Slice& slice = slices_[k];
    slice.centerX = cx;
    slice.centerY = cy;
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        // Only a structure's edge can be on the hull.
        const bool edge = m.at(i, j, k) && (i == 0 || i + 1 == g.size[0] || !m.at(i - 1, j, k) || !m.at(i + 1, j, k));
        if (!edge) continue;
        slice.support_mm.resize(kDirections, 0.0);
        const double x = i * g.spacing_mm.x - cx, y = j * g.spacing_mm.y - cy;
        for (int n = 0; n < kDirections; ++n) {
          const double a = n * kFullTurn / kDirections;
          slice.support_mm[n] = std::max(slice.support_mm[n], x * std::cos(a) + y * std::sin(a));
        }
      }
  }
}

void BodyHull::fillGaps() {
  for (int k = 0; k < int(slices_.size()); ++k) {
    if (!slices_[k].support_mm.empty()) continue;
    for (int away = 1; away < int(slices_.size()); ++away)
      for (const int from : {k - away, k + away})
        if (slices_[k].support_mm.empty() && from >= 0 && from < int(slices_.size()) &&
            !slices_[from].support_mm.empty())
          slices_[k].support_mm = slices_[from].support_mm;
  }
}

void BodyHull::smooth(double sliceSpacing_mm) {
  const int count = static_cast<int>(slices_.size());
  const auto over = [&](double reach_mm, auto combine) {
    const std::vector<Slice> before = slices_;
    const int reach = static_cast<int>(reach_mm / sliceSpacing_mm);
    for (int k = 0; k < count; ++k)
      for (int n = 0; n < kDirections; ++n) {
        double value = 0, weights = 0;
        for (int d = -reach; d <= reach; ++d)
          combine(value, weights, before[std::clamp(k + d, 0, count - 1)].support_mm[n], d * sliceSpacing_mm);
        slices_[k].support_mm[n] = value / weights;
      }
  };
  over(kEnclose_mm, [](double& value, double& weights, double s, double) { value = std::max(value, s), weights = 1; });
  over(3 * kSmooth_mm, [](double& value, double& weights, double s, double away_mm) {
    const double w = std::exp(-0.5 * away_mm * away_mm / (kSmooth_mm * kSmooth_mm));
    value += w * s;
    weights += w;
  });
}

void BodyHull::makeRadii(double grow_mm) {
  for (Slice& slice : slices_) {
    slice.radius_mm.assign(kDirections, 1e9);
    for (int n = 0; n < kDirections; ++n)
      for (int m = 0; m < kDirections; ++m) {
        const double c = std::cos((n - m) * kFullTurn / kDirections);
        if (c > 0.05) slice.radius_mm[n] = std::min(slice.radius_mm[n], (slice.support_mm[m] + grow_mm) / c);
      }
  }
}

double BodyHull::depth_mm(double x_mm, double y_mm, int k) const {
  const Slice& here = slices_[k];
  const double x = x_mm - here.centerX, y = y_mm - here.centerY;
  double a = std::atan2(y, x) / kFullTurn * kDirections;
  if (a < 0) a += kDirections;
  const int n = static_cast<int>(a);
  const double t = a - n, r0 = here.radius_mm[n % kDirections], r1 = here.radius_mm[(n + 1) % kDirections];
  const double slope = (r1 - r0) / (0.5 * (r0 + r1) * kFullTurn / kDirections);
  return (r0 + (r1 - r0) * t - std::hypot(x, y)) / std::sqrt(1 + slope * slope);
}

}  // namespace insonate
