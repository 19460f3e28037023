#pragma once

#include <insonate/simulator/LiveImaging.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace insonate::live {

/// Pool of LiveFrame objects. A frame and the memory of its reference counts are reused when its last owner releases
/// it, so that new frames allocate nothing. Any thread may release a frame. The pool lives as long as one of its frames
/// is in use.
class FramePool : public std::enable_shared_from_this<FramePool> {
 public:
  static std::shared_ptr<FramePool> make() { return std::shared_ptr<FramePool>(new FramePool); }

  /// Returns an unused frame, which still has its former contents.
  std::shared_ptr<LiveFrame> acquire();

  /// Maximum number of unused frames that are kept for reuse; further ones are freed.
  static constexpr std::size_t kSpare = 4;

  struct Slot {
    LiveFrame frame;
    /// Memory of the reference counts of one shared_ptr: a few pointers.
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
