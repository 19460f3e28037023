#pragma once

#include "store/sql/Address.h"

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptStore.h>

#include <filesystem>
#include <string>

namespace insonate::store {

/// Folder of the recordings of a store: StoreServices::recordings, else beside its file; "": none is kept.
std::filesystem::path recordingsFolder(const Address& address, const std::filesystem::path& wanted);
/// The folder of a store's file: FILE.recordings.
std::filesystem::path recordingsBeside(const std::filesystem::path& database);

/// The name under which `folder` keeps the recording of an attempt: ID.attempt.
std::filesystem::path keptRecording(const std::filesystem::path& folder, const std::string& attempt);

/// Fills in KeptAttempt::recordingFile.
void findRecording(KeptAttempt& kept, const std::filesystem::path& folder);

/// Copies `file` into `folder` as the recording of an attempt, readable by the owner alone; `folder` is made where it
/// is missing. Gives whether a file is there that was not there before. Fails, with nothing left behind, where the file
/// cannot be read or is not the one with this SHA-256, and where the folder cannot be written.
Result<bool> keepRecording(const std::filesystem::path& folder, const std::string& attempt,
                           const std::filesystem::path& file, const std::string& hash);

/// Copies each recording of one folder into another, which is made where it is missing; what both have is replaced
/// where it differs, and what the other has besides stays. A folder that is missing has no recordings.
Result<void> copyRecordings(const std::filesystem::path& from, const std::filesystem::path& to,
                            const Progress& progress = {});

}  // namespace insonate::store
