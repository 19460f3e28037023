#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/procedure/AttemptHeader.h>
#include <insonate/procedure/AttemptScore.h>

#include <cstdint>
#include <filesystem>

namespace insonate {

/// Returns the facts that an attempt's header contains. The caller adds the recording; if the recording belongs to no
/// store, the caller also adds id, person and level.
AttemptFacts beginningOf(const AttemptHeader& header);

/// Adds how the attempt ended: Completed or otherwise Abandoned, with the metrics and points of its score.
void addEnding(AttemptFacts& facts, AttemptStatus status, std::int64_t length_us, const AttemptScore& score);

/// Computes AttemptFacts::recordingHash of a file. It distinguishes the original recording from copies that were
/// changed later.
Result<std::string> recordingHash(const std::filesystem::path& file);

/// Adds name and SHA-256 of a recording's file, and the hash of the hands' motion; this hash is "" if the motion cannot
/// be read.
Result<void> addRecording(AttemptFacts& facts, const std::filesystem::path& file);

/// Hands that a recording may show: only a person's, or also those of a script (`session --script`), as in
/// demonstrations.
enum class Hands { Person, PersonOrScript };

/// Computes all facts from the recording alone. The recording is replayed and scored by the present version of its
/// procedure, which the facts name. Fails if the recording cannot be read, if damage prevents the metrics, if its
/// procedure is missing here or older than the recording's, or if a script moved the hands although a person's are
/// required.
Result<AttemptFacts> factsOfRecording(const std::filesystem::path& file, Hands hands = Hands::Person);

/// Completes the facts of an attempt that has begun. Id, person and level stay; the procedure's version is that of the
/// beginning. Fails like factsOfRecording(), leaving `facts` unchanged.
Result<void> takeRecording(AttemptFacts& facts, const std::filesystem::path& file);

}  // namespace insonate
