#pragma once

#include "StoreAccess.h"

#include <insonate/core/Result.h>
#include <insonate/procedure/RecordingProof.h>

#include <CLI/CLI.hpp>

#include <string>

namespace insonate::cli {

/// A recording to replay, and what it proves.
struct CheckedRecording {
  std::string file;
  RecordingProof proof;
};

/// The recording of an attempt of the store, before it is replayed as such.
struct RecordingCheck {
  std::string attempt;  ///< its id; "": the recording is replayed as nobody's
  StoreOptions store;

  void addTo(CLI::App& command);
  /// The file to replay, `recording` or, where that is "", the one that the store keeps of the attempt, and what it
  /// proves, with the store's key where one is asked. Fails where it is not the attempt's, or who signs in may not see
  /// the attempt.
  Result<CheckedRecording> check(const std::string& recording) const;
};

}  // namespace insonate::cli
