#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/procedure/AttemptHeader.h>
#include <insonate/procedure/AttemptScore.h>

#include <cstdint>
#include <filesystem>

namespace insonate {

/// Returns the facts that a recording's header contains. The caller adds the facts of the recording (addRecording()),
/// and id, person and level if the header has none.
AttemptFacts beginningOf(const AttemptHeader& header);

/// Adds the end of an attempt to its facts: duration, metrics, points, and the state Completed or Abandoned.
void addEnding(AttemptFacts& facts, AttemptStatus status, std::int64_t length_us, const AttemptScore& score);

/// Computes AttemptFacts::recordingHash, the SHA-256 of a recording's file, which differs for changed copies.
Result<std::string> recordingHash(const std::filesystem::path& file);

/// Adds to an attempt's facts the file name and SHA-256 of its recording, and AttemptFacts::handsHash, which is "" if
/// the recorded motion cannot be read.
Result<void> addRecording(AttemptFacts& facts, const std::filesystem::path& file);

/// Recordings that are accepted: only those of a person, or also demonstrations, in which a script moved probe and
/// needle (`session --script`).
enum class Hands { Person, PersonOrScript };

/// Computes all facts from the recording alone. The recording is replayed and scored by the present version of its
/// procedure, which the facts name. Fails if the recording cannot be read, if damage prevents the metrics, if its
/// procedure is missing in this installation or older than the recording's, or if `hands` does not allow a scripted
/// recording.
Result<AttemptFacts> factsOfRecording(const std::filesystem::path& file, Hands hands = Hands::Person);

/// Adds to the facts of a begun attempt what its recording contains. Id, person, level and the procedure's version
/// stay. Fails like factsOfRecording(), with `facts` unchanged.
Result<void> takeRecording(AttemptFacts& facts, const std::filesystem::path& file);

}  // namespace insonate
