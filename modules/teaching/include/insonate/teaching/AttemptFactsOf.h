#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/procedure/AttemptHeader.h>
#include <insonate/procedure/AttemptScore.h>

#include <cstdint>
#include <filesystem>

namespace insonate {

/// Returns the facts about an attempt that the header of its recording contains. The caller adds the facts of the
/// recording (addRecording()); if the header has no id, person and level, the caller also adds these.
AttemptFacts factsFromHeader(const AttemptHeader& header);

/// Adds the facts about the end of an attempt: duration, metrics, points, and the state Completed or Abandoned.
void addEnding(AttemptFacts& facts, AttemptStatus status, std::int64_t length_us, const AttemptScore& score);

/// Computes AttemptFacts::recordingHash: the SHA-256 of the file of a recording.
Result<std::string> recordingHash(const std::filesystem::path& file);

/// Adds to an attempt's facts the file name and SHA-256 of its recording, and AttemptFacts::handsHash, which is "" if
/// the recorded motion cannot be read.
Result<void> addRecording(AttemptFacts& facts, const std::filesystem::path& file);

/// Kinds of recordings that are accepted: only recordings in which a person moved probe and needle, or also
/// demonstrations, in which a script moved them (`insonate-cli session --script`).
enum class Hands { Person, PersonOrScript };

/// Computes all facts about an attempt from its recording alone. The recording is replayed and scored with the present
/// version of its procedure; AttemptFacts::procedureVersion is this version. Fails if the recording cannot be read, if
/// damage prevents the metrics, if the procedure is missing in this installation or older than when the recording was
/// made, or if `hands` does not allow a scripted recording.
Result<AttemptFacts> factsOfRecording(const std::filesystem::path& file, Hands hands = Hands::Person);

/// Adds the facts that the recording of an attempt contains to the facts from its beginning. Id, person, level and the
/// version of the procedure do not change. Fails as factsOfRecording() does; `facts` is then unchanged.
Result<void> takeRecording(AttemptFacts& facts, const std::filesystem::path& file);

}  // namespace insonate
