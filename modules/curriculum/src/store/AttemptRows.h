#pragma once

#include "store/Proofs.h"
#include "store/sql/Transaction.h"

#include <insonate/curriculum/AttemptStore.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace insonate::store {

/// Accepted difference between the clocks of two computers.
inline constexpr std::int64_t kClocksDiffer_us = 600'000'000;

/// Columns of the table `attempts` that storedAttemptOf() reads.
#define INSONATE_ATTEMPT_COLUMNS                                                                                    \
  "arrival, id, person, curriculum, curriculum_version, level, procedure, procedure_version, case_name, begun_us, " \
  "state, crashed, length_us, succeeded, critical_errors, points, metrics, voided_us, " INSONATE_PROOF_COLUMN       \
  ", sitting, case_hash, workstation, "                                                                             \
  "recording, recording_hash, void_reason, "                                                                        \
  "COALESCE((SELECT MIN(hash) FROM hands WHERE attempt = attempts.id), '')"
/// The first of INSONATE_ATTEMPT_COLUMNS, as factsOf() reads them for AttemptStore::history().
#define INSONATE_HISTORY_COLUMNS                                                                                    \
  "arrival, id, person, curriculum, curriculum_version, level, procedure, procedure_version, case_name, begun_us, " \
  "state, crashed, length_us, succeeded, critical_errors, points, metrics, voided_us, " INSONATE_PROOF_COLUMN       \
  ", sitting"

/// SQL condition for attempts that were abandoned before the needle reached the skin. The pattern matches the text that
/// metricsText() writes for such an attempt. `attempts` must be the only table in the query with such columns.
#define INSONATE_UNTRIED "state = 'abandoned' AND metrics LIKE '%[\"passes\",_,0.0]%'"
/// SQL condition for attempts that count, equal to counts() of Judgement.h. `attempts` must be the only table in the
/// query with such columns.
#define INSONATE_COUNTS "state <> 'open' AND voided_us IS NULL AND NOT (" INSONATE_UNTRIED ")"

/// SQL condition for attempts that were no practice: neither free practice nor a test that was not open.
#define INSONATE_AT_LEVELS "curriculum <> '' AND sitting NOT IN ('practice', 'undecided')"

/// SQL expression that computes Member::changes (a counter of changes) of the selected attempts.
#define INSONATE_CHANGES                                         \
  "SUM(CASE WHEN state <> 'open' THEN 2 - crashed ELSE 0 END + " \
  "CASE WHEN voided_us IS NULL THEN 0 ELSE 1 END)"

/// Converts a row of INSONATE_HISTORY_COLUMNS to facts.
AttemptFacts factsOf(const Row& row);
/// Converts a row of INSONATE_ATTEMPT_COLUMNS to an attempt.
StoredAttempt storedAttemptOf(const Row& row);
std::vector<AttemptFacts> allFacts(const std::vector<Row>& rows);
/// Returns all attempts of a person; see AttemptStore::history().
std::vector<AttemptFacts> historyOf(Transaction& transaction, const std::string& person);
/// Returns how an attempt ended (Open, Completed or Abandoned), even if it was voided later. `row`:
/// INSONATE_HISTORY_COLUMNS or INSONATE_ATTEMPT_COLUMNS.
AttemptState stateOfEnd(const Row& row);
std::optional<StoredAttempt> findAttempt(Transaction& transaction, const std::string& id);

/// Checks the facts of a begun attempt before they are stored, as checkEnded() does for an ended one; fails with a
/// sentence.
Result<void> checkBegun(const AttemptFacts& facts);
Result<void> checkEnded(const AttemptFacts& facts);
/// Fails if an attempt begins or ends later than `now_us`, or begins before its curriculum was published in this
/// store; a version that is not published here is not checked.
Result<void> refuseImpossibleDates(Transaction& transaction, const AttemptFacts& facts, std::int64_t now_us);
/// Tells whether two attempts have the same facts about the beginning. sameEnd() compares the facts about the end.
bool sameBeginning(const AttemptFacts& a, const AttemptFacts& b);
bool sameEnd(const AttemptFacts& a, const AttemptFacts& b);

/// Inserts a begun attempt and gives it the next StoredAttempt::arrival. `run`: UUID of the opened database
/// (Core::run()).
void insertAttempt(Transaction& transaction, const AttemptFacts& facts, const std::string& run);
void endAttempt(Transaction& transaction, const AttemptFacts& facts, bool crashed);

}  // namespace insonate::store
