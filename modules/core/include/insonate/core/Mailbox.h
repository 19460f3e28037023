#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <optional>
#include <thread>
#include <utility>

namespace insonate {

/// Passes the latest value from any thread to any thread; post() replaces a value that has not been taken. This is a
/// triple buffer generalized to any number of writers. It uses no lock and allocates nothing. A thread waits only while
/// more than 30 other threads are inside post() or takeLatest().
template <class T>
class Mailbox {
 public:
  /// Puts a copy of a value into the mailbox. Replaces a value that no thread has taken yet.
  void post(const T& value) {
    const int slot = claim();
    slots_[slot] = value;
    if (const int replaced = latest_.exchange(slot, std::memory_order_acq_rel); replaced >= 0) release(replaced);
  }

  /// Returns the latest value and empties the mailbox; no value if nothing was posted since the last call.
  std::optional<T> takeLatest() {
    const int slot = latest_.exchange(kNone, std::memory_order_acq_rel);
    if (slot < 0) return std::nullopt;
    std::optional<T> value(std::move(slots_[slot]));
    release(slot);
    return value;
  }

 private:
  static constexpr int kNone = -1;

  int claim() {
    std::uint32_t free = free_.load(std::memory_order_acquire);
    for (;;) {
      if (free == 0) {
        std::this_thread::yield();
        free = free_.load(std::memory_order_acquire);
      } else if (free_.compare_exchange_weak(free, free & (free - 1), std::memory_order_acq_rel)) {
        return std::countr_zero(free);
      }
    }
  }
  void release(int slot) { free_.fetch_or(1U << slot, std::memory_order_acq_rel); }

  std::array<T, 32> slots_{};
  std::atomic<std::uint32_t> free_{~0U};  ///< one bit per slot, set while the slot is free
  std::atomic<int> latest_{kNone};
};

}  // namespace insonate
