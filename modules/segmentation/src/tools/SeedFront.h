#pragma once

#include "Work.h"

#include <insonate/segmentation/GrowFromSeeds.h>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace insonate::segmentation {

/// Fronts that grow from labeled seeds over a grid in the order of their cost (R. B. Dial, "Algorithm 360", CACM 12,
/// 1969). Costs are integers and a step costs less than kBuckets, so that a ring of lists replaces a priority queue.
/// Voxels of equal cost are settled in the order in which they were reached.
class SeedFront {
 public:
  static constexpr std::uint32_t kBuckets = 1U << 13;

  SeedFront(Proposal& labels, const Selection& contested)
      : labels_(labels.labels), contested_(contested.mask), cost_(labels_.voxels.size(), kFar), buckets_(kBuckets) {}

  /// Grows the fronts. `costOf(cost, from, to, axis)` returns the cost of the path to `to` by a step from `from`, where
  /// the path to `from` costs `cost`. The result must be at least `cost` and less than `cost` + kBuckets.
  template <class CostOf>
  void run(Work& work, const CostOf& costOf) {
    for (std::size_t v = 0; v < labels_.voxels.size(); ++v)
      if (labels_.voxels[v] != Proposal::kKeep) reach(v, 0);
    const std::size_t total = std::max<std::size_t>(waiting_, 1) + count(contested_);
    for (std::uint32_t now = 0; waiting_ > 0; ++now) {
      std::vector<std::uint32_t>& bucket = buckets_[now % kBuckets];
      // Voxels reached at no further cost are appended to this list.
      for (std::size_t n = 0; n < bucket.size(); ++n) {
        const std::uint32_t v = bucket[n];
        --waiting_;
        if (cost_[v] != now) continue;
        if (++settled_ % kCheck == 0) work.checkpoint(std::min(1.0, double(settled_) / double(total)));
        spread(v, now, costOf);
      }
      bucket.clear();
    }
  }

  /// Returns the cost of a voxel after the run; the maximum number if no seed has reached it.
  std::uint32_t cost(std::size_t v) const { return cost_[v]; }

 private:
  static constexpr std::uint32_t kFar = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::size_t kCheck = 1 << 18;

  static std::size_t count(const Volume<std::uint8_t>& mask) {
    std::size_t sum = 0;
    for (const std::uint8_t voxel : mask.voxels) sum += voxel;
    return sum;
  }

  void reach(std::size_t v, std::uint32_t cost) {
    cost_[v] = cost;
    buckets_[cost % kBuckets].push_back(static_cast<std::uint32_t>(v));
    ++waiting_;
  }

  template <class CostOf>
  void spread(std::uint32_t v, std::uint32_t now, const CostOf& costOf) {
    const auto& size = labels_.geometry.size;
    const std::array<std::uint32_t, 3> stride{1, std::uint32_t(size[0]), std::uint32_t(size[0]) * size[1]};
    const std::array<std::uint32_t, 3> at{v % stride[1], v / stride[1] % size[1], v / stride[2]};
    for (int axis = 0; axis < 3; ++axis)
      for (const bool on : {false, true}) {
        if (on ? at[axis] + 1 >= std::uint32_t(size[axis]) : at[axis] == 0) continue;
        const std::uint32_t to = on ? v + stride[axis] : v - stride[axis];
        if (!contested_.voxels[to]) continue;
        const std::uint32_t cost = costOf(now, v, to, axis);
        if (cost >= cost_[to]) continue;
        labels_.voxels[to] = labels_.voxels[v];
        reach(to, cost);
      }
  }

  Volume<std::uint8_t>& labels_;
  const Volume<std::uint8_t>& contested_;
  std::vector<std::uint32_t> cost_;
  std::vector<std::vector<std::uint32_t>> buckets_;
  std::size_t waiting_ = 0, settled_ = 0;
};

}  // namespace insonate::segmentation
