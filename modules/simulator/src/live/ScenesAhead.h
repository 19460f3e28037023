#pragma once

#include <insonate/ultrasound/SceneSource.h>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace insonate::live {

/// Computes parts of future acoustic scenes in advance, on its own thread of low priority.
class ScenesAhead {
 public:
  explicit ScenesAhead(std::shared_ptr<const SceneSource> source);
  /// Cancels the computation in progress and waits for the thread.
  ~ScenesAhead();

  /// Requests the parts in the region around the probe, nearest parts first. Replaces the former request.
  void want(const Region& region_mm, double detail_mm);
  /// Cancels the former request.
  void drop();

 private:
  struct Wanted {
    Region region_mm;
    double detail_mm;
  };
  void work();

  const std::shared_ptr<const SceneSource> source_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Wanted> wanted_;
  std::uint64_t asked_ = 0;  ///< number of requests so far
  std::atomic<bool> stopping_{false}, dropping_{false};
  std::thread thread_;  ///< declared last, since the thread uses the other members
};

}  // namespace insonate::live
