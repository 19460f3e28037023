#pragma once

#include "store/sql/Address.h"

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptStore.h>

#include <filesystem>
#include <string>

namespace insonate::store {

/// Folder of a store's recordings: StoreServices::recordings, else the folder beside the store's file; empty if none
/// are kept.
std::filesystem::path recordingsFolder(const Address& address, const std::filesystem::path& wanted);
/// The folder of a store's file: FILE.recordings.
std::filesystem::path recordingsBeside(const std::filesystem::path& database);

/// The name under which `folder` keeps the recording of an attempt: ID.attempt.
std::filesystem::path keptRecording(const std::filesystem::path& folder, const std::string& attempt);

/// Fills in KeptAttempt::recordingFile.
void findRecording(KeptAttempt& kept, const std::filesystem::path& folder);

/// Copies `file` into `folder` as the recording of an attempt, readable by the owner alone; creates `folder` if
/// needed. Returns whether the file is new there. Fails, leaving nothing behind, if the file cannot be read or has
/// another SHA-256, or if the folder cannot be written.
Result<bool> keepRecording(const std::filesystem::path& folder, const std::string& attempt,
                           const std::filesystem::path& file, const std::string& hash);

/// Copies each recording of one folder into another, which is created if needed; differing files are replaced, and
/// further files stay. A missing folder has no recordings.
Result<void> copyRecordings(const std::filesystem::path& from, const std::filesystem::path& to,
                            const Progress& progress = {});

}  // namespace insonate::store
