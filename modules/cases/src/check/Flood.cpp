#include "Flood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace insonate::check {
namespace {

using Index = std::array<int, 3>;

/// Growth over the voxels of one label, each of which is visited once. The queue stores one voxel for each run along a
/// row; storing all voxels would take hundreds of megabytes for the background of a CT.
class Flood {
 public:
  Flood(const LabelMap& labels, std::uint8_t label) : labels_(labels), label_(label), visited_(labels.voxels.size()) {}

  void seed(const Index& at) {
    if (isOpen(at)) waiting_.push_back(at);
  }
  /// Visits all voxels connected with the seeds by faces (`reach` 0), or also by edges and corners (1). Calls `visit`
  /// with the first voxel of each run, and its length.
  template <class Visit>
  void grow(int reach, const Visit& visit) {
    while (!waiting_.empty()) {
      Index first = waiting_.back();
      waiting_.pop_back();
      if (!isOpen(first)) continue;
      int end = first[0];
      while (isOpen({first[0] - 1, first[1], first[2]})) --first[0];
      while (isOpen({end, first[1], first[2]})) ++end;
      const auto row = visited_.begin() + std::ptrdiff_t(labels_.geometry.offset(0, first[1], first[2]));
      std::fill(row + first[0], row + end, true);
      visit(first, end - first[0]);
      for (int k = -1; k <= 1; ++k)
        for (int j = -1; j <= 1; ++j)
          if (std::abs(j) + std::abs(k) == 1 || (reach > 0 && j != 0))
            seedRow(first[0] - reach, end + reach, first[1] + j, first[2] + k);
    }
  }

  VoxelSet visited() && { return std::move(visited_); }

 private:
  bool isOpen(const Index& at) const {
    const VolumeGeometry& g = labels_.geometry;
    if (!g.contains(at[0], at[1], at[2])) return false;
    const std::size_t v = g.offset(at[0], at[1], at[2]);
    return labels_.voxels[v] == label_ && !visited_[v];
  }
  void seedRow(int from, int end, int j, int k) {
    bool before = false;
    for (int i = from; i < end; ++i) {
      const bool open = isOpen({i, j, k});
      if (open && !before) waiting_.push_back({i, j, k});
      before = open;
    }
  }

  const LabelMap& labels_;
  std::uint8_t label_;
  std::vector<Index> waiting_;
  VoxelSet visited_;
};

/// A part that grows run by run.
struct Growing {
  /// End of the run at one index of the axis.
  struct End {
    int at;
    Vec3 sum;
    double count = 0;

    void add(int index, const Vec3& sumOfRun, double countOfRun, bool further) {
      if (further) at = index, sum = {}, count = 0;
      if (index == at) sum = sum + sumOfRun, count += countOfRun;
    }
  };
  int axis;
  std::size_t voxels = 0;
  End low{std::numeric_limits<int>::max(), {}}, high{-1, {}};

  void add(const Index& first, int length) {
    voxels += std::size_t(length);
    if (axis == 0) {
      for (int i = first[0]; i < first[0] + length; ++i) addAt(i, {double(i), double(first[1]), double(first[2])}, 1);
    } else {
      const Vec3 middle{first[0] + 0.5 * (length - 1), double(first[1]), double(first[2])};
      addAt(first[axis], middle * length, length);
    }
  }
  void addAt(int index, const Vec3& sum, double count) {
    low.add(index, sum, count, index < low.at);
    high.add(index, sum, count, index > high.at);
  }
  Part part(const Transform& patientFromIndex) const {
    return {voxels, low.at, high.at, patientFromIndex * (low.sum / low.count),
            patientFromIndex * (high.sum / high.count)};
  }
};

}  // namespace

VoxelSet floodFromSides(const LabelMap& labels, std::uint8_t label, int endAxis) {
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
          flood.grow(0, [](const Index&, int) {});
        }
  }
  return std::move(flood).visited();
}

double pieceLength_mm(const LabelMap& labels, Vec3 index) {
  const VolumeGeometry& g = labels.geometry;
  const Index at{int(std::lround(index.x)), int(std::lround(index.y)), int(std::lround(index.z))};
  if (!g.contains(at[0], at[1], at[2])) return 0;
  Flood flood(labels, labels.at(at[0], at[1], at[2]));
  flood.seed(at);
  Index low = at, high = at;
  flood.grow(1, [&](const Index& first, int length) {
    const Index last{first[0] + length - 1, first[1], first[2]};
    for (int a = 0; a < 3; ++a) low[a] = std::min(low[a], first[a]), high[a] = std::max(high[a], last[a]);
  });
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
        Growing growing{axis};
        flood.grow(1, [&](const Index& first, int length) { growing.add(first, length); });
        if (growing.voxels > 0) parts.push_back(growing.part(patientFromIndex));
      }
  std::ranges::stable_sort(parts, std::greater{}, &Part::voxels);
  return parts;
}

}  // namespace insonate::check
