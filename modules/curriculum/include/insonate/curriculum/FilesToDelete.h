#pragma once

#include <insonate/core/Result.h>

#include <string>
#include <vector>

namespace insonate {

/// Attempts whose recordings a store has deleted, for a server that has other files about them.
struct FilesToDelete {
  std::vector<std::string> attempts{};  ///< ids of the attempts, whose other files the caller deletes in any case
  Result<void> recordings{};            ///< failure if a recording is still there; the next call tries again
};

}  // namespace insonate
