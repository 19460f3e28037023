#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptStore.h>

#include <filesystem>
#include <string>

namespace insonate {

/// Result of checking whether a recording proves that an attempt was really made.
struct AttemptProofOf {
  AttemptProof proof = AttemptProof::Unproven;  ///< result of the check: Unproven or Proven
  std::string why{};                            ///< reason, a sentence, if the attempt is unproven
  /// true: the database issued the recording's nonce to this attempt; false: id and level in the recording must not be
  /// used.
  bool isOfStore = false;
};

/// Gets from the database the key for the nonce in the recording's header, and checks the recording with this key, as
/// an attempt of the header's id by `facts.person`. Fails with a sentence if the recording was changed or damaged, if
/// the nonce was issued to another person or attempt, or if the recording cannot be read.
Result<AttemptProofOf> proofOfAttempt(const AttemptStore& attempts, const AttemptFacts& facts,
                                      const std::filesystem::path& recording);

}  // namespace insonate
