#pragma once

#include "store/sql/Transaction.h"

#include <insonate/curriculum/AttemptFacts.h>

#include <string>
#include <string_view>

namespace insonate::store {

/// AttemptFacts::proof of a row of attempts, as a column.
#define INSONATE_PROOF_COLUMN "COALESCE((SELECT state FROM proofs WHERE attempt = attempts.id), 'unproven')"

/// As they are in the table.
std::string_view nameOf(AttemptProof proof);
AttemptProof proofNamed(std::string_view name);

/// With an attempt's end, as its program found it. That an instructor accepted it, or that it was there before there
/// were proofs, no program finds: then nothing vouches for it.
void keepProof(Transaction& transaction, const AttemptFacts& facts);
/// Takes over the proof that another store has of an attempt, or its later acceptance. `acceptedBy` as in the table.
void mergeProof(Transaction& transaction, const std::string& attempt, AttemptProof proof,
                const std::string& acceptedBy);
void acceptAttempt(Transaction& transaction, const std::string& attempt, const std::string& by);

}  // namespace insonate::store
