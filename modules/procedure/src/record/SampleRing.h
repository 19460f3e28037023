#pragma once

#include <insonate/procedure/AttemptEvent.h>
#include <insonate/procedure/AttemptSample.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <variant>

namespace insonate::record {

using RingEntry = std::variant<AttemptSample, AttemptEvent>;
static_assert(std::is_trivially_copyable_v<RingEntry>, "the servo hands it over without memory of its own");

/// Lock-free queue of samples and events from one writer thread to one reader thread. If the queue is full, new entries
/// are dropped and counted as lost.
class SampleRing {
 public:
  void put(const RingEntry& entry) noexcept {
    const std::uint64_t at = written_.load(std::memory_order_relaxed);
    if (room() == 0) {
      lost_.fetch_add(1, std::memory_order_relaxed);
      return;
    }
    entries_[at % entries_.size()] = entry;
    written_.store(at + 1, std::memory_order_release);
  }

  /// Returns the number of entries that put() can still accept; call it on the writer's thread.
  std::size_t room() const noexcept {
    return entries_.size() - (written_.load(std::memory_order_relaxed) - read_.load(std::memory_order_acquire));
  }

  /// Removes all waiting entries and passes each to `take`; call it on the reader's thread.
  template <class Take>
  void drain(const Take& take) {
    std::uint64_t at = read_.load(std::memory_order_relaxed);
    for (const std::uint64_t end = written_.load(std::memory_order_acquire); at < end; ++at) {
      take(entries_[at % entries_.size()]);
      read_.store(at + 1, std::memory_order_release);
    }
  }

  /// Returns the number of entries lost since the last call.
  std::uint32_t takeLost() noexcept { return lost_.exchange(0, std::memory_order_relaxed); }

 private:
  std::array<RingEntry, 4096> entries_{};
  std::atomic<std::uint64_t> written_{0}, read_{0};
  std::atomic<std::uint32_t> lost_{0};
};

}  // namespace insonate::record
