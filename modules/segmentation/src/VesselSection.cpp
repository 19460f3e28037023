#include "VesselSection.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace insonate::segmentation {

SectionFinder::SectionFinder(const LabelMap& labels, std::uint8_t label)
    : labels_(labels),
      label_(label),
      indexFromPatient_(labels.geometry.indexFromPatient()),
      seen_(std::size_t(kWidth) * kWidth) {}

/// At least half of the eight voxels around, by their weights.
SectionFinder::Place SectionFinder::placeOf(Vec3 index) const {
  const auto& size = labels_.geometry.size;
  std::array<int, 3> low{}, next{};
  std::array<double, 3> share{};
  for (int axis = 0; axis < 3; ++axis) {
    if (!(index[axis] > -0.5 && index[axis] < size[axis] - 0.5)) return Place::BeyondVolume;
    const double x = std::clamp(index[axis], 0.0, size[axis] - 1.0);
    low[axis] = static_cast<int>(x), next[axis] = std::min(low[axis] + 1, size[axis] - 1);
    share[axis] = x - low[axis];
  }
  double inside = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const bool i = corner & 1, j = corner & 2, k = corner & 4;
    if (labels_.at(i ? next[0] : low[0], j ? next[1] : low[1], k ? next[2] : low[2]) == label_)
      inside += (i ? share[0] : 1 - share[0]) * (j ? share[1] : 1 - share[1]) * (k ? share[2] : 1 - share[2]);
  }
  return inside >= 0.5 ? Place::Inside : Place::Outside;
}

std::optional<VesselSection> SectionFinder::find(Vec3 at_mm, Vec3 axis) {
  const Vec3 aside = std::abs(axis.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 u = normalized(cross(axis, aside)), v = cross(axis, u);
  const auto pointOf = [&](int n) {
    return at_mm + u * (kStep_mm * (n % kWidth - kHalf)) + v * (kStep_mm * (n / kWidth - kHalf));
  };
  const Vec3 at = indexFromPatient_ * at_mm;
  const Vec3 along = indexFromPatient_.linear * u * kStep_mm, across = indexFromPatient_.linear * v * kStep_mm;
  std::ranges::fill(seen_, std::uint8_t{0});
  open_.clear();
  VesselSection section;
  const auto visit = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= kWidth || y >= kWidth) return;
    const int n = y * kWidth + x;
    if (seen_[n]) return;
    seen_[n] = 1;
    const Place place = placeOf(at + along * (x - kHalf) + across * (y - kHalf));
    if (place == Place::Inside) open_.push_back(n);
    section.cut |= place == Place::BeyondVolume;
  };
  // If the point itself has just left a curved vessel, the vessel is one step aside.
  for (int ring = 0; ring <= 2 && open_.empty(); ++ring)
    for (int y = -ring; y <= ring && open_.empty(); ++y)
      for (int x = -ring; x <= ring && open_.empty(); ++x) visit(kHalf + x, kHalf + y);
  Vec3 sum;
  for (std::size_t i = 0; i < open_.size(); ++i) {
    const int x = open_[i] % kWidth, y = open_[i] / kWidth;
    sum = sum + pointOf(open_[i]);
    visit(x + 1, y), visit(x - 1, y), visit(x, y + 1), visit(x, y - 1);
  }
  if (open_.empty()) return std::nullopt;
  section.center_mm = sum / static_cast<double>(open_.size());
  section.area_mm2 = static_cast<double>(open_.size()) * kStep_mm * kStep_mm;
  for (const int n : open_) section.reach_mm = std::max(section.reach_mm, norm(pointOf(n) - section.center_mm));
  return section;
}

Vec3 SectionFinder::middleOfBall(Vec3 at_mm, double radius_mm) const {
  const VolumeGeometry& g = labels_.geometry;
  const Vec3 center = indexFromPatient_ * at_mm;
  const Transform patientFromIndex = g.patientFromIndex();
  std::array<int, 3> first{}, last{};
  for (int axis = 0; axis < 3; ++axis) {
    const double half = radius_mm / g.spacing_mm[axis];
    first[axis] = std::max(0, static_cast<int>(std::ceil(center[axis] - half)));
    last[axis] = std::min(g.size[axis] - 1, static_cast<int>(std::floor(center[axis] + half)));
  }
  Vec3 sum;
  std::size_t count = 0;
  for (int k = first[2]; k <= last[2]; ++k)
    for (int j = first[1]; j <= last[1]; ++j)
      for (int i = first[0]; i <= last[0]; ++i) {
        if (labels_.at(i, j, k) != label_) continue;
        const Vec3 point = patientFromIndex * Vec3{double(i), double(j), double(k)};
        if (norm(point - at_mm) <= radius_mm) sum = sum + point, ++count;
      }
  return count ? sum / static_cast<double>(count) : at_mm;
}

}  // namespace insonate::segmentation
