#pragma once

#include <cstdint>
#include <string>

namespace insonate::store {

/// Tells a process from all others, of this computer and others, now and after a restart.
struct Process {
  std::string machine{};  ///< the computer's id
  std::string boot{};
  std::int64_t pid = 0;
  std::int64_t started = 0;  ///< clock ticks after the boot; pids come again

  static Process current();
  /// Asked on the same machine only.
  bool isAlive() const;
};

}  // namespace insonate::store
