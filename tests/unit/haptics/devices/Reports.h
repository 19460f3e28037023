#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace insonate::test {

using Bytes = std::vector<std::uint8_t>;

/// Report of the arm in resources/haptics/devices, its first encoder at a count.
inline Bytes armReport(int encoder) {
  Bytes report(14, 0);
  report[0] = static_cast<std::uint8_t>(encoder);
  report[1] = static_cast<std::uint8_t>(encoder >> 8);
  return report;
}

inline bool isZero(const Bytes& output) {
  return std::all_of(output.begin(), output.end(), [](std::uint8_t b) { return b == 0; });
}

/// True as soon as `holds` does; false when it has not for ten seconds.
inline bool eventually(const std::function<bool()>& holds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (std::chrono::steady_clock::now() < end) {
    if (holds()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return holds();
}

}  // namespace insonate::test
