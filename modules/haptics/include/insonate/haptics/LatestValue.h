#pragma once

#include <array>
#include <atomic>
#include <utility>

namespace insonate {

/// Passes the latest value from one writer thread to one reader thread. No value is copied, and neither thread waits or
/// allocates. The writer's thread releases the resources of a value when it overwrites the value. This is a triple
/// buffer. In contrast, insonate::Mailbox is for many writers and returns each value only once.
template <class T>
class LatestValue {
 public:
  /// Writes a value; call on the writer's thread.
  void write(T value) {
    slots_[back_] = std::move(value);
    back_ = middle_.exchange(back_ | kFresh, std::memory_order_acq_rel) & kSlot;
  }
  /// Returns the latest value, or a default value before the first; call it on the reader's thread. The value is
  /// constant until the next call.
  const T& read() noexcept {
    if (middle_.load(std::memory_order_relaxed) & kFresh)
      front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kSlot;
    return slots_[front_];
  }

 private:
  static constexpr int kSlot = 3, kFresh = 4;
  std::array<T, 3> slots_{};
  std::atomic<int> middle_{1};
  int back_ = 0, front_ = 2;
};

}  // namespace insonate
