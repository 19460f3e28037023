#pragma once

#include "StoreAccess.h"

#include <insonate/core/Result.h>
#include <insonate/procedure/RecordingProof.h>

#include <CLI/CLI.hpp>

#include <string>

namespace insonate::cli {

/// Whether a recording is that of an attempt of the store, before it is replayed as such.
struct RecordingCheck {
  std::string attempt;  ///< its id; "": the recording is replayed as nobody's
  StoreOptions store;

  void addTo(CLI::App& command);
  /// What it proves, with the store's key where one is asked. Fails where it is not the attempt's, or who signs in may
  /// not see the attempt.
  Result<RecordingProof> check(const std::string& recording) const;
};

}  // namespace insonate::cli
