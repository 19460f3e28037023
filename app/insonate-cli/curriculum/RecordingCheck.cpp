#include "RecordingCheck.h"

#include "../Commands.h"
#include "Answer.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/teaching/AttemptFactsOf.h>

namespace insonate::cli {

void RecordingCheck::addTo(CLI::App& command) {
  CLI::Option* which =
      command.add_option("--attempt", attempt, "Replay it only if it is the recording of this attempt of the store")
          ->check(notEmpty());
  addSignInOptions(command, store);
  command.get_option("--as")->required(false)->needs(which);
  which->needs(command.get_option("--as"));
  addDatabaseOption(command, store);
}

Result<void> RecordingCheck::check(const std::string& recording) const {
  if (attempt.empty()) return {};
  const auto by = signIn(store);
  if (!by) return tl::unexpected(by.error());
  const auto kept = AttemptStore(*by).attempt(attempt);
  if (!kept) return tl::unexpected(kept.error());
  const auto hash = recordingHash(recording);
  if (!hash) return tl::unexpected(hash.error());
  if (*hash == kept->facts.recordingHash) return {};
  return fail(recording + " is not the recording of the attempt " + attempt + " of " + timeText(kept->facts.begun_us) +
              ": it is another file, or was changed since. Look for '" + kept->facts.recording + "' of " +
              kept->facts.workstation + ", or replay it without --attempt, as nobody's.");
}

}  // namespace insonate::cli
