#pragma once

#include <insonate/simulator/LiveImaging.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace insonate::live {

/// Frames that are used again when the last holder lets go, together with the memory of their reference counts, so that
/// an image allocates nothing. Any thread may let go. Lives as long as a frame of it is held.
class FramePool : public std::enable_shared_from_this<FramePool> {
 public:
  static std::shared_ptr<FramePool> make() { return std::shared_ptr<FramePool>(new FramePool); }

  /// A frame that nobody else holds, with what it held before.
  std::shared_ptr<LiveFrame> acquire();

  /// Frames that nobody holds and that wait to be used again; more than a few are freed.
  static constexpr std::size_t kSpare = 4;

  struct Slot {
    LiveFrame frame;
    /// For the reference counts of one shared_ptr: a few pointers.
    alignas(std::max_align_t) std::byte counts[128];
  };

 private:
  FramePool() = default;
  template <class T>
  friend class CountMemory;
  void giveBack(std::unique_ptr<Slot> slot);

  std::mutex mutex_;
  std::vector<std::unique_ptr<Slot>> free_;
};

}  // namespace insonate::live
