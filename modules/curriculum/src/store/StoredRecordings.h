#pragma once

#include "store/sql/Address.h"

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptStore.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace insonate::store {

/// Returns the folder for recordings of a database: `wanted` (StoreServices::recordings), else the folder beside the
/// database file; empty if none are kept.
std::filesystem::path recordingsFolder(const Address& address, const std::filesystem::path& wanted);
/// Returns the folder for recordings beside a database file: FILE.recordings.
std::filesystem::path recordingsBeside(const std::filesystem::path& database);

/// Returns the path of the recording of an attempt in `folder`: ID.attempt.
std::filesystem::path storedRecording(const std::filesystem::path& folder, const std::string& attempt);

/// Tells whether `folder` has the recording of an attempt; an empty `folder` has none.
bool isRecordingKept(const std::filesystem::path& folder, const std::string& attempt);
/// Returns the number of bytes that `folder` has of the recordings of attempts, complete or in part.
std::int64_t sizeOfRecordings(const std::filesystem::path& folder, const std::vector<std::string>& attempts);

/// Deletes the recordings of attempts from `folder`, also those that have arrived in part. Fails if a file is still
/// there; the others are deleted.
Result<void> removeRecordings(const std::filesystem::path& folder, const std::vector<std::string>& attempts);

/// Sets StoredAttempt::recordingFile to the recording in `folder`, if there is one.
void findRecording(StoredAttempt& kept, const std::filesystem::path& folder);

/// Copies `file` into `folder` as the recording of an attempt, readable by the owner alone; creates `folder` if needed.
/// Returns whether the copy is new. Fails without leaving a file if `file` cannot be read or does not have the SHA-256
/// `hash`, or if the folder cannot be written.
Result<bool> storeRecording(const std::filesystem::path& folder, const std::string& attempt,
                            const std::filesystem::path& file, const std::string& hash);

/// A recording that arrives in parts.
struct ReceivedPart {
  std::int64_t size_bytes = 0;  ///< bytes received so far
  bool isComplete = false;
};
/// Appends `bytes` at `offset_bytes` to the recording of an attempt that arrives in `folder`. If `offset_bytes` is not
/// the end of the part that has arrived, nothing changes, so that bytes that arrive twice are stored once; the sender
/// continues at the returned size. A file of `total_bytes` becomes the recording of the attempt if it has the SHA-256
/// `hash`; otherwise the file is removed. A file of more than 256 MB is also removed.
Result<ReceivedPart> receiveRecording(const std::filesystem::path& folder, const std::string& attempt,
                                      const std::string& hash, std::int64_t offset_bytes, std::int64_t total_bytes,
                                      std::string_view bytes);

/// Copies all recordings of the folder `from` into the folder `to`, which is created if needed; files that differ are
/// replaced, other files in `to` stay. Does nothing if `from` is missing.
Result<void> copyRecordings(const std::filesystem::path& from, const std::filesystem::path& to,
                            const Progress& progress = {});

}  // namespace insonate::store
