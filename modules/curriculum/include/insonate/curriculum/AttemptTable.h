#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Curriculum.h>

#include <string>
#include <vector>

/// Columns that every table of attempts shares (CSV; Csv.h).
namespace insonate {

/// "proven", "accepted", "earlier", "demonstration", "not proven".
const char* wordOf(AttemptProof proof);

/// "id", "begun (UTC)", ..., "assistance", "state", "broke off", "voided", "succeeded", "passed", ..., "proof".
std::vector<std::string> attemptColumns();

/// The fields of attemptColumns(): "broke off" is hasBrokenOff(), "succeeded" is the procedure's aim, "passed" the
/// level's rule by this curriculum, "" where nothing is passed (Judgement.h). "assistance" is what the level gives by
/// this curriculum, "" in free practice, where the trainee chooses it. `curriculum` may be null.
std::vector<std::string> attemptRow(const AttemptFacts& attempt, const Curriculum* curriculum);

}  // namespace insonate
