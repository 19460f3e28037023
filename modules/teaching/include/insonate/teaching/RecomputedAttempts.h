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

/// Comparison of the facts in a store with the recordings that the store keeps.
struct RecomputedAttempts {
  struct Left {
    std::string attempt{}, person{};  ///< ids
    std::string why{};
  };
  struct Flagged {
    std::string attempt{}, person{};  ///< ids
    std::vector<std::string> words{};
  };
  std::int64_t compared = 0;  ///< number of attempts
  std::vector<StoreDifference> differences{};
  std::vector<Left> left{};                  ///< ended attempts that cannot be recomputed
  std::map<std::string, int> notCompared{};  ///< values of compared attempts that were not compared, with the reason;
                                             ///< number of attempts for each
  /// Attempts with implausible values, including those that could not be recomputed.
  std::vector<Flagged> implausible{};
};

/// Compares an attempt's stored values with those of its recording, computed by the code that scored it. Values are
/// equal within a billionth, since mathematical libraries differ in the last digits. A metric is compared if its
/// definition still has the stored version; outcome and points are compared if the procedure still has the stored
/// version. Fails if the recording cannot be scored.
Result<void> compareWithRecording(const AttemptFacts& stored, const std::filesystem::path& recording,
                                  RecomputedAttempts& into);

/// Compares all attempts of a store; administrators only. Takes about a second for ten attempts; can be cancelled
/// between two attempts.
Result<RecomputedAttempts> recomputeAttempts(const SignedIn& by, const Progress& progress);

}  // namespace insonate
