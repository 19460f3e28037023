#pragma once

#include "StoreAccess.h"

#include <insonate/core/Result.h>

#include <CLI/CLI.hpp>

#include <string>

namespace insonate::cli {

/// The recording of an attempt of the store, before it is replayed as such.
struct RecordingCheck {
  std::string attempt;  ///< its id; "": the recording is replayed as nobody's
  StoreOptions store;

  void addTo(CLI::App& command);
  /// The file to replay: `recording`, or where that is "" the one that the store keeps of the attempt. Fails where it
  /// is not that of the attempt, or who signs in may not see the attempt.
  Result<std::string> find(const std::string& recording) const;
};

}  // namespace insonate::cli
