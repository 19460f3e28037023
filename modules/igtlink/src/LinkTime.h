#pragma once

#include <chrono>
#include <cstdint>

namespace insonate {

/// Converts ns since 1970 to the time stamp of a message: seconds in the upper 32 bits, and 2^-32 s in the lower.
constexpr std::uint64_t linkTimestamp(std::int64_t time_ns) {
  if (time_ns <= 0) return 0;
  const auto time = static_cast<std::uint64_t>(time_ns);
  // Rounded up, since linkTime_ns() rounds down.
  return ((time / 1'000'000'000) << 32) | ((((time % 1'000'000'000) << 32) + 999'999'999) / 1'000'000'000);
}

/// Inverse of linkTimestamp().
constexpr std::int64_t linkTime_ns(std::uint64_t timestamp) {
  return static_cast<std::int64_t>((timestamp >> 32) * 1'000'000'000 +
                                   (((timestamp & 0xFFFF'FFFF) * 1'000'000'000) >> 32));
}

/// The present time, ns since 1970.
inline std::int64_t timeSince1970_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now().time_since_epoch())
      .count();
}

/// The present time on CLOCK_MONOTONIC, ns.
inline std::int64_t monotonicTime_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace insonate
