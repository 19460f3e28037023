#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptStore.h>

#include <filesystem>
#include <string>

namespace insonate {

/// Proof of an attempt by its recording.
struct AttemptProofOf {
  AttemptProof proof = AttemptProof::Unproven;  ///< Unproven or Proven
  std::string why{};                            ///< a sentence if nothing is proven
  bool isOfStore =
      false;  ///< the store issued the nonce to this attempt; otherwise the recording's id and level must not be used
};

/// Asks the store for the key of the nonce in the recording's header, and checks the recording with this key. The
/// attempt is that of the header, and of `facts.person`. Fails with a sentence if the recording was changed or damaged
/// after it was recorded, if the store issued the nonce to another person or attempt, or if the recording cannot be
/// read.
Result<AttemptProofOf> proofOfAttempt(const AttemptStore& attempts, const AttemptFacts& facts,
                                      const std::filesystem::path& recording);

}  // namespace insonate
