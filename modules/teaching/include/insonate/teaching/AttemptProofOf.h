#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptStore.h>

#include <filesystem>
#include <string>

namespace insonate {

/// Proof of an attempt by its recording.
struct AttemptProofOf {
  AttemptProof proof = AttemptProof::Unproven;  ///< or Proven
  std::string why{};                            ///< a sentence where nothing is proven
  bool isOfStore =
      false;  ///< the store gave this attempt its nonce; else the recording's id and level are of no account
};

/// Asks the store for the key of the nonce in the recording's header, and compares the recording with it; the attempt
/// is that of the header, and of `facts.person`. Fails with a sentence where the recording was changed or damaged after
/// it was recorded, or the store gave its nonce to another person or attempt, and where it cannot be read.
Result<AttemptProofOf> proofOfAttempt(const AttemptStore& attempts, const AttemptFacts& facts,
                                      const std::filesystem::path& recording);

}  // namespace insonate
