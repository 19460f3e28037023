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

/// Computes what scenes to come will be made of, on a thread of its own that leaves the processors to everything else.
class ScenesAhead {
 public:
  explicit ScenesAhead(std::shared_ptr<const SceneSource> source);
  /// Stops the running computation.
  ~ScenesAhead();

  /// Requests the surroundings of the probe; nearest parts come first. Replaces the former request.
  void want(const Region& region_mm, double detail_mm);

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
  std::uint64_t asked_ = 0;  ///< how often
  std::atomic<bool> stopping_{false};
  std::thread thread_;  ///< last: it uses the others
};

}  // namespace insonate::live
