#pragma once

#include <insonate/haptics/HapticDevice.h>

#include <chrono>
#include <cstddef>
#include <deque>
#include <mutex>
#include <utility>
#include <vector>

namespace insonate::haptics {

inline std::int64_t monotonic_ns() noexcept {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// Queue of messages about devices for the user interface. May be used on any thread except the force loop's. The
/// oldest messages are dropped when kMost is exceeded.
class EventQueue {
 public:
  void put(DeviceEvent event) {
    event.time_ns = monotonic_ns();
    const std::lock_guard lock(mutex_);
    events_.push_back(std::move(event));
    if (events_.size() > kMost) events_.pop_front();
  }
  std::vector<DeviceEvent> take() {
    const std::lock_guard lock(mutex_);
    std::vector<DeviceEvent> taken(std::make_move_iterator(events_.begin()), std::make_move_iterator(events_.end()));
    events_.clear();
    return taken;
  }

 private:
  static constexpr std::size_t kMost = 1000;
  std::mutex mutex_;
  std::deque<DeviceEvent> events_;
};

}  // namespace insonate::haptics
