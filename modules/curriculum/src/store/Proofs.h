#pragma once

#include "store/sql/Transaction.h"

#include <insonate/curriculum/AttemptFacts.h>

#include <string>
#include <string_view>

namespace insonate::store {

/// AttemptFacts::proof of a row of attempts, as a column.
#define INSONATE_PROOF_COLUMN "COALESCE((SELECT state FROM proofs WHERE attempt = attempts.id), 'unproven')"

/// Name in the table.
std::string_view nameOf(AttemptProof proof);
AttemptProof proofNamed(std::string_view name);

/// Stores the proof that a program found at an attempt's end. Acceptance by an instructor, and existence before there
/// were proofs, are not found by a program: such a value stores an unproven attempt.
void keepProof(Transaction& transaction, const AttemptFacts& facts);
/// Merges the proof that another store has of an attempt, or its later acceptance. `acceptedBy` as in the table.
void mergeProof(Transaction& transaction, const std::string& attempt, AttemptProof proof,
                const std::string& acceptedBy);
void acceptAttempt(Transaction& transaction, const std::string& attempt, const std::string& by);

}  // namespace insonate::store
