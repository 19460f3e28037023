#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>

namespace insonate::haptics {

/// Histogram of durations with logarithmic buckets of 2.3 %, from 10 ns to 20 s; filled by one thread and read by
/// others.
class TickHistogram {
 public:
  void add(std::int64_t ns) noexcept {
    const double decades = std::log10(std::max(1.0, static_cast<double>(ns) / kFirst_ns));
    const int bucket = std::min(kBuckets - 1, static_cast<int>(decades * kPerDecade));
    counts_[bucket].fetch_add(1, std::memory_order_relaxed);
    if (ns > max_ns_.load(std::memory_order_relaxed)) max_ns_.store(ns, std::memory_order_relaxed);
  }
  void clear() noexcept {
    for (auto& count : counts_) count.store(0, std::memory_order_relaxed);
    max_ns_.store(0, std::memory_order_relaxed);
  }
  std::uint64_t count() const {
    std::uint64_t sum = 0;
    for (const auto& count : counts_) sum += count.load(std::memory_order_relaxed);
    return sum;
  }
  double max_us() const { return static_cast<double>(max_ns_.load(std::memory_order_relaxed)) * 1e-3; }
  /// Returns the quantile for `share` (0 to 1) of the durations, as the upper end of its bucket.
  double quantile_us(double share) const {
    const double wanted = share * static_cast<double>(count());
    double sum = 0;
    for (int i = 0; i < kBuckets; ++i) {
      sum += static_cast<double>(counts_[i].load(std::memory_order_relaxed));
      if (sum > 0 && sum >= wanted) return std::min(max_us(), kFirst_ns * std::pow(10, (i + 1) / kPerDecade) * 1e-3);
    }
    return 0;
  }

 private:
  static constexpr double kFirst_ns = 10, kPerDecade = 100;
  static constexpr int kBuckets = 930;
  std::array<std::atomic<std::uint32_t>, kBuckets> counts_{};
  std::atomic<std::int64_t> max_ns_{0};
};

}  // namespace insonate::haptics
