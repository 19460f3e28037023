#include "Flood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace insonate::check {
namespace {

using Index = std::array<int, 3>;

/// Depth-first growth over the voxels of one label; each voxel is visited once.
class Flood {
 public:
  Flood(const LabelMap& labels, std::uint8_t label)
      : labels_(labels), label_(label), visited(labels.voxels.size(), 0) {}

  void seed(Index at) {
    const VolumeGeometry& g = labels_.geometry;
    if (!g.contains(at[0], at[1], at[2])) return;
    const std::size_t v = g.offset(at[0], at[1], at[2]);
    if (visited[v] || labels_.voxels[v] != label_) return;
    visited[v] = 1;
    stack_.push_back(at);
  }
  void growByFaces() {
    while (!stack_.empty()) {
      const Index p = pop();
      for (int a = 0; a < 3; ++a)
        for (int step : {-1, 1}) {
          Index q = p;
          q[a] += step;
          seed(q);
        }
    }
  }
  std::vector<Index> growByCorners() {
    std::vector<Index> grown;
    while (!stack_.empty()) {
      const Index p = pop();
      grown.push_back(p);
      for (int n = 0; n < 27; ++n) seed({p[0] + n % 3 - 1, p[1] + n / 3 % 3 - 1, p[2] + n / 9 - 1});
    }
    return grown;
  }

 private:
  Index pop() {
    const Index p = stack_.back();
    stack_.pop_back();
    return p;
  }

  const LabelMap& labels_;
  std::uint8_t label_;
  std::vector<Index> stack_;

 public:
  std::vector<std::uint8_t> visited;
};

Part partOf(const std::vector<Index>& voxels, const Transform& patientFromIndex, int axis) {
  const auto [lowest, highest] = std::ranges::minmax(voxels, {}, [&](const Index& p) { return p[axis]; });
  Part part{voxels.size(), lowest[axis], highest[axis], {}, {}};
  Vec3 lowSum, highSum;
  double lowCount = 0, highCount = 0;
  for (const Index& p : voxels) {
    const Vec3 index{double(p[0]), double(p[1]), double(p[2])};
    if (p[axis] == part.low) lowSum = lowSum + index, ++lowCount;
    if (p[axis] == part.high) highSum = highSum + index, ++highCount;
  }
  part.lowEnd_mm = patientFromIndex * (lowSum / lowCount);
  part.highEnd_mm = patientFromIndex * (highSum / highCount);
  return part;
}

}  // namespace

std::vector<std::uint8_t> floodFromSides(const LabelMap& labels, std::uint8_t label, int endAxis) {
  Flood flood(labels, label);
  const auto& size = labels.geometry.size;
  for (int side = 0; side < 3; ++side) {
    if (side == endAxis) continue;
    const int u = (side + 1) % 3, v = (side + 2) % 3;
    for (int a = 0; a < size[u]; ++a)
      for (int b = 0; b < size[v]; ++b)
        for (int face : {0, size[side] - 1}) {
          Index at;
          at[side] = face, at[u] = a, at[v] = b;
          flood.seed(at);
        }
  }
  flood.growByFaces();
  return std::move(flood.visited);
}

double pieceLength_mm(const LabelMap& labels, Vec3 index) {
  const VolumeGeometry& g = labels.geometry;
  const Index at{int(std::lround(index.x)), int(std::lround(index.y)), int(std::lround(index.z))};
  if (!g.contains(at[0], at[1], at[2])) return 0;
  Flood flood(labels, labels.at(at[0], at[1], at[2]));
  flood.seed(at);
  Vec3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
  for (const Index& p : flood.growByCorners())
    for (int a = 0; a < 3; ++a) low[a] = std::min(low[a], double(p[a])), high[a] = std::max(high[a], double(p[a]));
  double longest_mm = 0;
  for (int a = 0; a < 3; ++a) longest_mm = std::max(longest_mm, (high[a] - low[a] + 1) * g.spacing_mm[a]);
  return longest_mm;
}

std::vector<Part> partsOf(const LabelMap& labels, std::uint8_t label, int axis) {
  Flood flood(labels, label);
  const Transform patientFromIndex = labels.geometry.patientFromIndex();
  std::vector<Part> parts;
  const auto& size = labels.geometry.size;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        flood.seed({i, j, k});
        if (const auto grown = flood.growByCorners(); !grown.empty())
          parts.push_back(partOf(grown, patientFromIndex, axis));
      }
  std::ranges::stable_sort(parts, std::greater{}, &Part::voxels);
  return parts;
}

}  // namespace insonate::check
