#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Curriculum.h>

#include <string>
#include <vector>

/// Columns that every table of attempts shares (CSV; Csv.h).
namespace insonate {

/// Name of a proof in tables: "proven", "accepted", "earlier", "demonstration", "not proven".
const char* wordOf(AttemptProof proof);

/// Column names: "id", "begun (UTC)", ..., "assistance", "state", "broke off", "voided", "succeeded", "passed", ...,
/// "proof".
std::vector<std::string> attemptColumns();

/// Values of attemptColumns(). "broke off" is hasBrokenOff(); "succeeded": the procedure's aim was reached; "passed":
/// the level's rule in this curriculum was met, "" if there is nothing to pass (Judgement.h). "assistance" is that of
/// the level in this curriculum, "" in free practice, in which the trainee chooses it. `curriculum` may be null.
std::vector<std::string> attemptRow(const AttemptFacts& attempt, const Curriculum* curriculum);

}  // namespace insonate
