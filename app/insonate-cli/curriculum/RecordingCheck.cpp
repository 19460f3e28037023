#include "RecordingCheck.h"

#include "../Commands.h"
#include "Answer.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/teaching/AttemptFactsOf.h>

namespace insonate::cli {

void RecordingCheck::addTo(CLI::App& command) {
  CLI::Option* which =
      command
          .add_option("--attempt", attempt,
                      "An attempt of the store: replay the recording that the store keeps of it, or RECORDING only if "
                      "it is that of this attempt")
          ->check(notEmpty());
  addSignInOptions(command, store);
  command.get_option("--as")->required(false)->needs(which);
  which->needs(command.get_option("--as"));
  addDatabaseOption(command, store);
}

Result<std::string> RecordingCheck::find(const std::string& recording) const {
  if (attempt.empty()) return recording;
  const auto by = signIn(store);
  if (!by) return tl::unexpected(by.error());
  const auto kept = AttemptStore(*by).attempt(attempt);
  if (!kept) return tl::unexpected(kept.error());
  const std::string file = recording.empty() ? kept->recordingFile.string() : recording;
  const std::string elsewhere = "Look for '" + kept->facts.recording + "' of " + kept->facts.workstation;
  if (kept->facts.recording.empty()) return fail("The attempt " + attempt + " has no recording.");
  if (file.empty())
    return fail("The store keeps no recording of the attempt " + attempt + ". " + elsewhere +
                ", and name the file before --attempt.");
  const auto hash = recordingHash(file);
  if (!hash) return tl::unexpected(hash.error());
  if (*hash == kept->facts.recordingHash) return file;
  return fail(file + " is not the recording of the attempt " + attempt + " of " + timeText(kept->facts.begun_us) +
              ": it is another file, or was changed since. " + elsewhere +
              ", or replay it without --attempt, as nobody's.");
}

}  // namespace insonate::cli
