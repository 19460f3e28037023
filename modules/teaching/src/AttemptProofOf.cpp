#include <insonate/procedure/AttemptRecording.h>
#include <insonate/teaching/AttemptFactsOf.h>
#include <insonate/teaching/AttemptProofOf.h>

#include <utility>

namespace insonate {
namespace {

Result<AttemptProofOf> asProof(RecordingProof proof, bool isOfStore) {
  if (proof.state == ProofState::Broken) return fail(std::move(proof.why));
  if (proof.state == ProofState::Proven) return AttemptProofOf{AttemptProof::Proven, "", isOfStore};
  return AttemptProofOf{AttemptProof::Unproven, std::move(proof.why), isOfStore};
}

}  // namespace

Result<AttemptProofOf> proofOfAttempt(const AttemptStore& attempts, const AttemptFacts& facts,
                                      const std::filesystem::path& file) {
  return proofOfAttempt(
      [&](const AttemptFacts& claimed, const std::string& nonce) { return attempts.originOf(claimed, nonce); }, facts,
      file);
}

Result<AttemptProofOf> proofOfAttempt(const NonceOriginOf& originOf, const AttemptFacts& facts,
                                      const std::filesystem::path& file) {
  const auto recording = AttemptRecording::open(file);
  if (!recording) return tl::unexpected(recording.error());
  const RecordedFor& whose = recording->header().recordedFor;
  if (whose.nonce.empty()) return asProof(recording->proof(std::nullopt), false);
  AttemptFacts claimed = factsFromHeader(recording->header());
  claimed.person = facts.person;
  const auto origin = originOf(claimed, whose.nonce);
  if (!origin) return tl::unexpected(origin.error());
  switch (origin->kind) {
    case NonceOrigin::Kind::Given:
      return asProof(recording->proof(origin->key), true);
    case NonceOrigin::Kind::Elsewhere:
      return asProof(recording->proof(std::nullopt), false);
    case NonceOrigin::Kind::Forged:
      break;
  }
  if (whose.person != facts.person)
    return fail(file.string() +
                " was recorded for another person and counts only for that person. Record an attempt of your own.");
  return fail(file.string() +
              " was changed after it was recorded: its header names another attempt or level than the one "
              "that it was begun for. Look for an unchanged copy.");
}

}  // namespace insonate
