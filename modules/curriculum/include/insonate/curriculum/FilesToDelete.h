#pragma once

#include <insonate/core/Result.h>

#include <string>
#include <vector>

namespace insonate {

/// Attempts whose recordings a store has deleted, for a server that has other files about them.
struct FilesToDelete {
  /// ids of the attempts; the caller deletes their other files even if `recordings` is an error
  std::vector<std::string> attempts{};
  /// error if a recording could not be deleted; the next call of the function that returned this object tries again
  Result<void> recordings{};
};

}  // namespace insonate
