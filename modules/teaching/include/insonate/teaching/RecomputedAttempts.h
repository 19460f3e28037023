#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/curriculum/Implausible.h>
#include <insonate/curriculum/SignedIn.h>
#include <insonate/curriculum/StoreCheck.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace insonate {

/// Agreement of the facts in a store with the recordings that it keeps.
struct RecomputedAttempts {
  struct Left {
    std::string attempt{}, person{};  ///< ids
    std::string why{};
  };
  struct Flagged {
    std::string attempt{}, person{};  ///< ids
    std::vector<std::string> words{};
  };
  std::int64_t compared = 0;  ///< attempts
  std::vector<StoreDifference> differences{};
  std::vector<Left> left{};                  ///< ended attempts that cannot be recomputed
  std::map<std::string, int> notCompared{};  ///< of compared attempts: which values and why; of how many
  std::vector<Flagged> implausible{};        ///< whether or not they could be recomputed
};

/// Compares an attempt's stored values with those of its recording, computed by the code that scored it. Values are
/// equal within a billionth, since mathematical libraries differ in the last digits. Metrics are compared if their
/// definition has the stored version, outcome and points if the procedure has. Fails if the recording cannot be
/// scored.
Result<void> compareWithRecording(const AttemptFacts& stored, const std::filesystem::path& recording,
                                  RecomputedAttempts& into);

/// Does so for all attempts of a store; administrators only. A second for some ten of them; stops between two.
Result<RecomputedAttempts> recomputeAttempts(const SignedIn& by, const Progress& progress);

}  // namespace insonate
