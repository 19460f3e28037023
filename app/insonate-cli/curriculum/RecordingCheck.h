#pragma once

#include "StoreAccess.h"

#include <insonate/core/Result.h>

#include <CLI/CLI.hpp>

#include <string>

namespace insonate::cli {

/// Whether a recording is that of an attempt of the store, before it is replayed as such.
struct RecordingCheck {
  std::string attempt;  ///< its id; "": the recording is replayed as nobody's
  StoreOptions store;

  void addTo(CLI::App& command);
  /// Fails where it is not, or who signs in may not see the attempt.
  Result<void> check(const std::string& recording) const;
};

}  // namespace insonate::cli
