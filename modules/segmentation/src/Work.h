#pragma once

#include <insonate/core/Progress.h>
#include <insonate/image/VolumeGeometry.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <string_view>

namespace insonate::segmentation {

struct Cancelled {};

/// Runs loops over slices in parallel, reports progress, and checks for cancellation between batches of slices. When
/// cancelled, throws Cancelled, which is caught within this module.
class Work {
 public:
  Work(const Progress& progress, double expectedPasses) : progress_(progress), expectedPasses_(expectedPasses) {}

  void start(std::string_view doing) { doing_ = doing; }

  /// Runs one pass over `count` slices: calls body(k) for each slice, in any order.
  template <class Body>
  void slices(int count, const Body& body) {
    // Large enough to keep all cores busy, small enough that a batch of large slices takes far less than a second.
    constexpr int kBatch = 32;
    for (int begin = 0; begin < count; begin += kBatch) {
      const int end = std::min(count, begin + kBatch);
      tbb::parallel_for(begin, end, body);
      checkpoint(double(end) / count);
    }
    passes_ += 1;
  }

  /// Runs a part of a pass over `count` slices: calls body(k) for the slices from `begin` to before `end`. This part
  /// must take far less than a second, since cancellation is checked only at its end.
  template <class Body>
  void part(int begin, int end, int count, const Body& body) {
    tbb::parallel_for(begin, end, body);
    passes_ += double(end - begin) / count;
    checkpoint();
  }

  /// Runs one pass over the voxels of a grid: calls function(v) for each voxel, in any order.
  template <class Function>
  void voxels(const VolumeGeometry& g, const Function& function) {
    const std::size_t slice = std::size_t(g.size[0]) * g.size[1];
    slices(g.size[2], [&](int k) {
      for (std::size_t v = k * slice; v < (k + 1) * slice; ++v) function(v);
    });
  }

  void checkpoint(double shareOfPass = 0) const {
    const double fraction = std::min((passes_ + shareOfPass) / expectedPasses_, 0.99);
    if (!report(progress_, doing_, fraction)) throw Cancelled{};
  }

 private:
  const Progress& progress_;
  double expectedPasses_;
  double passes_ = 0;
  std::string_view doing_;
};

}  // namespace insonate::segmentation
