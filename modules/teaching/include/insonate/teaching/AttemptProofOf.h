#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptStore.h>

#include <filesystem>
#include <functional>
#include <string>

namespace insonate {

/// Result of the check whether a recording proves that an attempt was really made.
struct AttemptProofOf {
  AttemptProof proof = AttemptProof::Unproven;  ///< result of the check: Unproven or Proven
  std::string why{};                            ///< reason, a sentence, if the attempt is unproven
  /// true: the curriculum database issued the recording's nonce to this attempt. false: id and level in the recording
  /// are not trustworthy and must not be used.
  bool isOfStore = false;
};

/// Checks the recording of an attempt with the key that the curriculum database issued with the nonce in the header.
/// The attempt is the one with the id in the header, made by `facts.person`. Fails with a sentence if the recording was
/// changed or damaged, if the nonce was issued to another person or attempt, or if the recording cannot be read.
Result<AttemptProofOf> proofOfAttempt(const AttemptStore& attempts, const AttemptFacts& facts,
                                      const std::filesystem::path& recording);

/// Function that returns the origin of a nonce, as AttemptStore::originOf() does, for a recording that claims to be of
/// the attempt with these facts.
using NonceOriginOf = std::function<Result<NonceOrigin>(const AttemptFacts& facts, const std::string& nonce)>;
/// Does the same check with a key that `originOf` returns.
Result<AttemptProofOf> proofOfAttempt(const NonceOriginOf& originOf, const AttemptFacts& facts,
                                      const std::filesystem::path& recording);

}  // namespace insonate
