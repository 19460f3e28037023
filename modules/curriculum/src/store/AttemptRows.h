#pragma once

#include "store/Proofs.h"
#include "store/sql/Transaction.h"

#include <insonate/curriculum/AttemptStore.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace insonate::store {

/// Columns of attempts that keptOf() reads.
#define INSONATE_ATTEMPT_COLUMNS                                                                                    \
  "arrival, id, person, curriculum, curriculum_version, level, procedure, procedure_version, case_name, begun_us, " \
  "state, crashed, length_us, succeeded, critical_errors, points, metrics, voided_us, " INSONATE_PROOF_COLUMN       \
  ", case_hash, workstation, "                                                                                      \
  "recording, recording_hash, void_reason, "                                                                        \
  "COALESCE((SELECT MIN(hash) FROM hands WHERE attempt = attempts.id), '')"
/// The first of them, which history needs.
#define INSONATE_HISTORY_COLUMNS                                                                                    \
  "arrival, id, person, curriculum, curriculum_version, level, procedure, procedure_version, case_name, begun_us, " \
  "state, crashed, length_us, succeeded, critical_errors, points, metrics, voided_us, " INSONATE_PROOF_COLUMN

/// Attempts that were abandoned before the skin: what metricsText() writes of one is looked for in its text. `attempts`
/// must be the only table with such columns, here and below.
#define INSONATE_UNTRIED "state = 'abandoned' AND metrics LIKE '%[\"passes\",_,0.0]%'"
/// Attempts that count, as counts() of Judgement.h says.
#define INSONATE_COUNTS "state <> 'open' AND voided_us IS NULL AND NOT (" INSONATE_UNTRIED ")"

/// Member::changes of the attempts that are added up.
#define INSONATE_CHANGES                                         \
  "SUM(CASE WHEN state <> 'open' THEN 2 - crashed ELSE 0 END + " \
  "CASE WHEN voided_us IS NULL THEN 0 ELSE 1 END)"

/// Converts a row of INSONATE_HISTORY_COLUMNS.
AttemptFacts factsOf(const Row& row);
/// Converts a row of INSONATE_ATTEMPT_COLUMNS.
KeptAttempt keptOf(const Row& row);
std::vector<AttemptFacts> allFacts(const std::vector<Row>& rows);
/// AttemptStore::history().
std::vector<AttemptFacts> historyOf(Transaction& transaction, const std::string& person);
/// Reads from a row of either kind how the attempt ended, whether it was voided or not.
AttemptState stateOfEnd(const Row& row);
std::optional<KeptAttempt> findAttempt(Transaction& transaction, const std::string& id);

/// Checks the facts of a caller before they are stored; fails with a sentence.
Result<void> checkBegun(const AttemptFacts& facts);
Result<void> checkEnded(const AttemptFacts& facts);
/// Tells whether both attempts have the same beginning, whatever their end.
bool sameBeginning(const AttemptFacts& a, const AttemptFacts& b);
bool sameEnd(const AttemptFacts& a, const AttemptFacts& b);

/// Inserts an attempt at its beginning and determines its arrival.
void insertAttempt(Transaction& transaction, const AttemptFacts& facts, const std::string& run);
void endAttempt(Transaction& transaction, const AttemptFacts& facts, bool crashed);

}  // namespace insonate::store
