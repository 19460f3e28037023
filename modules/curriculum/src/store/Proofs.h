#pragma once

#include "store/sql/Transaction.h"

#include <insonate/curriculum/AttemptFacts.h>

#include <string>
#include <string_view>

namespace insonate::store {

/// SQL expression that gives AttemptFacts::proof in a query on the table `attempts`.
#define INSONATE_PROOF_COLUMN                                                                                \
  "COALESCE((SELECT state FROM proofs WHERE attempt = attempts.id), (SELECT 'verifying' FROM verifications " \
  "WHERE attempt = attempts.id AND ended_us IS NULL), 'unproven')"

/// Returns the name of a proof in the table `proofs`.
std::string_view nameOf(AttemptProof proof);
AttemptProof proofNamed(std::string_view name);

/// Stores the proof (AttemptFacts::proof) that the caller determined at an attempt's end. Accepted and Earlier, which a
/// caller cannot determine, are stored as Unproven.
void storeProof(Transaction& transaction, const AttemptFacts& facts);
/// Stores the proof of an attempt that comes from another database, or its later acceptance. `acceptedBy`: id of the
/// person who accepted the attempt, "" for other proofs.
void mergeProof(Transaction& transaction, const std::string& attempt, AttemptProof proof,
                const std::string& acceptedBy);
/// Stores the result of the server's verification of an attempt that has no proof yet.
void concludeProof(Transaction& transaction, const std::string& attempt, AttemptProof proof);
void acceptAttempt(Transaction& transaction, const std::string& attempt, const std::string& by);

}  // namespace insonate::store
