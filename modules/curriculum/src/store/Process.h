#pragma once

#include <cstdint>
#include <string>

namespace insonate::store {

/// Identifies a process among all processes of all computers, also after a restart.
struct Process {
  std::string machine{};  ///< the computer's id
  std::string boot{};
  std::int64_t pid = 0;
  std::int64_t started = 0;  ///< start time in clock ticks after the boot; needed since process ids are reused

  static Process current();
  /// Tells whether the process is alive. Call it only on the process's own machine.
  bool isAlive() const;
};

}  // namespace insonate::store
