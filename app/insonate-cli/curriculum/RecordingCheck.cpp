#include "RecordingCheck.h"

#include "../Commands.h"
#include "Answer.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/teaching/AttemptFactsOf.h>
#include <insonate/teaching/AttemptProofOf.h>

namespace insonate::cli {
namespace {

RecordingProof proofIn(const AttemptStore& attempts, const AttemptFacts& facts, const std::string& recording) {
  const auto proven = proofOfAttempt(attempts, facts, recording);
  if (!proven) return {ProofState::Broken, proven.error().message};
  if (proven->proof == AttemptProof::Proven) return {ProofState::Proven, ""};
  return {ProofState::Unproven, proven->why};
}

}  // namespace

void RecordingCheck::addTo(CLI::App& command) {
  CLI::Option* which = command
                           .add_option("--attempt", attempt,
                                       "Attempt of the store: replays the recording in the store, or RECORDING if it "
                                       "is the recording of this attempt")
                           ->check(notEmpty());
  addSignInOptions(command, store);
  command.get_option("--as")->required(false)->needs(which);
  which->needs(command.get_option("--as"));
  addDatabaseOption(command, store);
}

Result<CheckedRecording> RecordingCheck::check(const std::string& recording) const {
  if (attempt.empty()) return CheckedRecording{recording, proofOf(recording, std::nullopt)};
  const auto by = signIn(store);
  if (!by) return tl::unexpected(by.error());
  const AttemptStore attempts(*by);
  const auto kept = attempts.attempt(attempt);
  if (!kept) return tl::unexpected(kept.error());
  const std::string file = recording.empty() ? kept->recordingFile.string() : recording;
  const std::string elsewhere = "Look for '" + kept->facts.recording + "' of " + kept->facts.workstation;
  if (kept->facts.recording.empty()) return fail("The attempt " + attempt + " has no recording.");
  if (file.empty())
    return fail("The store keeps no recording of the attempt " + attempt + ". " + elsewhere +
                ", and name the file before --attempt.");
  const auto hash = recordingHash(file);
  if (!hash) return tl::unexpected(hash.error());
  if (*hash != kept->facts.recordingHash)
    return fail(file + " is not the recording of the attempt " + attempt + " of " + timeText(kept->facts.begun_us) +
                ": it is another file, or was changed since. " + elsewhere +
                ", or replay it without --attempt, as the attempt of no person.");
  return CheckedRecording{file, proofIn(attempts, kept->facts, file)};
}

}  // namespace insonate::cli
