#include "store/Proofs.h"

#include <array>
#include <utility>

namespace insonate::store {
namespace {

constexpr std::array<std::pair<AttemptProof, std::string_view>, 6> kNames{{
    {AttemptProof::Unproven, "unproven"},
    {AttemptProof::Verifying, "verifying"},
    {AttemptProof::Proven, "proven"},
    {AttemptProof::Accepted, "accepted"},
    {AttemptProof::Earlier, "earlier"},
    {AttemptProof::Demonstration, "demonstration"},
}};

void insertProof(Transaction& transaction, const std::string& attempt, AttemptProof proof, const std::string& by) {
  if (transaction.number("SELECT COUNT(*) FROM proofs WHERE attempt = ?", attempt) == 0)
    transaction.run("INSERT INTO proofs VALUES (?, ?, ?)", attempt, nameOf(proof), by);
}

}  // namespace

std::string_view nameOf(AttemptProof proof) {
  for (const auto& [known, name] : kNames)
    if (known == proof) return name;
  return kNames.front().second;
}

AttemptProof proofNamed(std::string_view name) {
  for (const auto& [proof, known] : kNames)
    if (known == name) return proof;
  return AttemptProof::Unproven;
}

void storeProof(Transaction& transaction, const AttemptFacts& facts) {
  const bool isFound = facts.proof == AttemptProof::Proven || facts.proof == AttemptProof::Demonstration;
  insertProof(transaction, facts.id, isFound ? facts.proof : AttemptProof::Unproven, "");
}

void mergeProof(Transaction& transaction, const std::string& attempt, AttemptProof proof,
                const std::string& acceptedBy) {
  insertProof(transaction, attempt, proof, acceptedBy);
  if (proof == AttemptProof::Accepted) acceptAttempt(transaction, attempt, acceptedBy);
}

void concludeProof(Transaction& transaction, const std::string& attempt, AttemptProof proof) {
  insertProof(transaction, attempt, proof, "");
}

void acceptAttempt(Transaction& transaction, const std::string& attempt, const std::string& by) {
  transaction.run("UPDATE proofs SET state = 'accepted', accepted_by = ? WHERE attempt = ? AND state = 'unproven'", by,
                  attempt);
}

}  // namespace insonate::store
