#pragma once

#include "StoreAccess.h"

#include <insonate/core/Result.h>
#include <insonate/procedure/RecordingProof.h>

#include <CLI/CLI.hpp>

#include <string>

namespace insonate::cli {

/// A recording to replay, and the result of checking its origin.
struct CheckedRecording {
  std::string file;
  RecordingProof proof;
};

/// Command-line options for replaying the recording of an attempt in the curriculum database, and its checks.
struct RecordingCheck {
  std::string attempt;  ///< id of the attempt; "": the recording is not checked against an attempt
  StoreOptions store;

  void addTo(CLI::App& command);
  /// Returns the file to replay and its proof of origin, which uses the database's key if `attempt` is set. The file is
  /// `recording` or, if that is "", the database's copy of the attempt's recording. Fails if the file is not the
  /// attempt's recording, or if the signed-in user may not see the attempt.
  Result<CheckedRecording> check(const std::string& recording) const;
};

}  // namespace insonate::cli
