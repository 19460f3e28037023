#pragma once

#include "store/sql/Transaction.h"

#include <insonate/curriculum/AttemptFacts.h>

#include <string>
#include <string_view>

namespace insonate::store {

/// Column of a query on attempts that gives AttemptFacts::proof.
#define INSONATE_PROOF_COLUMN "COALESCE((SELECT state FROM proofs WHERE attempt = attempts.id), 'unproven')"

/// Name of a proof in the table.
std::string_view nameOf(AttemptProof proof);
AttemptProof proofNamed(std::string_view name);

/// Stores the proof that a program determined at an attempt's end. `Accepted` and `Earlier` cannot be determined by a
/// program: for these, an unproven attempt is stored.
void keepProof(Transaction& transaction, const AttemptFacts& facts);
/// Merges the proof of an attempt from another store, or the attempt's later acceptance. `acceptedBy` as in the table.
void mergeProof(Transaction& transaction, const std::string& attempt, AttemptProof proof,
                const std::string& acceptedBy);
void acceptAttempt(Transaction& transaction, const std::string& attempt, const std::string& by);

}  // namespace insonate::store
