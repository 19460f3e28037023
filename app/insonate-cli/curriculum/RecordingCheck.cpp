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
  CLI::Option* which =
      command.add_option("--attempt", attempt, "Replay it only if it is the recording of this attempt of the store")
          ->check(notEmpty());
  addSignInOptions(command, store);
  command.get_option("--as")->required(false)->needs(which);
  which->needs(command.get_option("--as"));
  addDatabaseOption(command, store);
}

Result<RecordingProof> RecordingCheck::check(const std::string& recording) const {
  if (attempt.empty()) return proofOf(recording, std::nullopt);
  const auto by = signIn(store);
  if (!by) return tl::unexpected(by.error());
  const AttemptStore attempts(*by);
  const auto kept = attempts.attempt(attempt);
  if (!kept) return tl::unexpected(kept.error());
  const auto hash = recordingHash(recording);
  if (!hash) return tl::unexpected(hash.error());
  if (*hash == kept->facts.recordingHash) return proofIn(attempts, kept->facts, recording);
  return fail(recording + " is not the recording of the attempt " + attempt + " of " + timeText(kept->facts.begun_us) +
              ": it is another file, or was changed since. Look for '" + kept->facts.recording + "' of " +
              kept->facts.workstation + ", or replay it without --attempt, as nobody's.");
}

}  // namespace insonate::cli
