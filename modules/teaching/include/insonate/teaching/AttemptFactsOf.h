#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/procedure/AttemptHeader.h>
#include <insonate/procedure/AttemptScore.h>

#include <cstdint>
#include <filesystem>

namespace insonate {

/// Facts that an attempt's header gives as it begins. The caller adds the recording, and id, person and level where the
/// recording belongs to no store.
AttemptFacts beginningOf(const AttemptHeader& header);

/// Adds how it ended: Completed, else Abandoned, with the metrics and points of its score.
void addEnding(AttemptFacts& facts, AttemptStatus status, std::int64_t length_us, const AttemptScore& score);

/// AttemptFacts::recordingHash of a file, which distinguishes the original recording from later copies that were
/// changed.
Result<std::string> recordingHash(const std::filesystem::path& file);

/// Name and SHA-256 of a recording's file, and the hash of what the hands did in it, "" where that cannot be read.
Result<void> addRecording(AttemptFacts& facts, const std::filesystem::path& file);

/// Hands that a recording may show: a person's only, or also a script's (`session --script`), as in demonstrations.
enum class Hands { Person, PersonOrScript };

/// All three, from the recording alone: it is replayed, and scored by the procedure as it is here, whose version the
/// facts name. Fails where it cannot be read, where damage leaves no metrics, and where its procedure is not here or
/// older than the recording's, and where a script moved the hands that should be a person's.
Result<AttemptFacts> factsOfRecording(const std::filesystem::path& file, Hands hands = Hands::Person);

/// Completes the facts of an attempt that has begun: id, person and level stay, and its procedure's version is the one
/// that it began with. Fails like factsOfRecording(), leaving `facts` unchanged.
Result<void> takeRecording(AttemptFacts& facts, const std::filesystem::path& file);

}  // namespace insonate
