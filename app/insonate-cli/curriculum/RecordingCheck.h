#pragma once

#include "StoreAccess.h"

#include <insonate/core/Result.h>
#include <insonate/procedure/RecordingProof.h>

#include <CLI/CLI.hpp>

#include <string>

namespace insonate::cli {

/// A recording to replay, and its proof of origin.
struct CheckedRecording {
  std::string file;
  RecordingProof proof;
};

/// Options and checks for replaying the recording of an attempt of the store.
struct RecordingCheck {
  std::string attempt;  ///< id of the attempt; "": the recording is replayed without an attempt
  StoreOptions store;

  void addTo(CLI::App& command);
  /// Returns the file to replay and its proof of origin; for a named `attempt` the proof uses the store's key. The file
  /// is `recording` or, if that is "", the recording that the store keeps of the attempt. Fails if the file is not the
  /// attempt's recording, or if the signed-in user may not see the attempt.
  Result<CheckedRecording> check(const std::string& recording) const;
};

}  // namespace insonate::cli
