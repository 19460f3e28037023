#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Curriculum.h>

#include <string>
#include <vector>

/// Columns that all tables of attempts (CSV files; see Csv.h) have in common.
namespace insonate {

/// Returns the word for an attempt's proof of origin in tables: "proven", "accepted", "earlier", "demonstration", "not
/// proven".
const char* nameOf(AttemptProof proof);

/// Returns the word for the circumstances of a test in tables: "opened", "self-administered", "practice", "earlier",
/// "undecided".
const char* nameOf(TestConditions testConditions);

/// Returns the column names of a table of attempts: "id", "begun (UTC)", ..., "assistance", "state", "broke off",
/// "voided", "succeeded", "passed", ..., "proof", "sitting".
std::vector<std::string> attemptColumns();

/// Returns the values of an attempt for attemptColumns(). "broke off": hasBrokenOff(). "succeeded": the procedure's aim
/// was reached. "passed": the level's rule in this curriculum was met; "" if the attempt has no level or does not count
/// (Judgement.h). "assistance": assistance of the level in this curriculum; "" in free practice. "sitting": "" if the
/// level is no test. `curriculum` may be null.
std::vector<std::string> attemptRow(const AttemptFacts& attempt, const Curriculum* curriculum);

/// Formats a number with the digits suitable for a table that people read: 0.25, 12.5, 130.
std::string numberOf(double value);

}  // namespace insonate
