#pragma once

#include <cstdint>
#include <string>

namespace insonate::store {

/// Identifies a process of this program uniquely among all computers and restarts.
struct Process {
  std::string machine{};  ///< id of the computer
  std::string boot{};
  std::int64_t pid = 0;
  std::int64_t started = 0;  ///< start time in clock ticks after the boot; needed since process ids are reused

  static Process current();
  /// Tells whether the process is still running. Call it only on the computer with the id `machine`.
  bool isAlive() const;
};

}  // namespace insonate::store
