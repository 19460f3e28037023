#pragma once

#include <cstdint>
#include <string>

namespace insonate::store {

/// Identity of a process among all processes of all computers, also after a restart.
struct Process {
  std::string machine{};  ///< the computer's id
  std::string boot{};
  std::int64_t pid = 0;
  std::int64_t started = 0;  ///< clock ticks after the boot; pids come again

  static Process current();
  /// Tells whether the process is alive; call on the same machine only.
  bool isAlive() const;
};

}  // namespace insonate::store
