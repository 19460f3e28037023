#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/curriculum/Implausible.h>
#include <insonate/curriculum/SignedIn.h>
#include <insonate/curriculum/StoreCheck.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/procedure/EventDifference.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace insonate {

/// Compares the needle events of a recording with the events that follow from its motion in its case (simulator/
/// EventCheck.h). Fails with a sentence if this is not possible, for example without the case.
using CompareEvents =
    std::function<Result<std::vector<EventDifference>>(const AttemptRecording& recording, const Progress& progress)>;

/// Result of the comparison of stored facts about attempts with facts that are recomputed from their recordings.
struct RecomputedAttempts {
  struct Left {
    std::string attempt{}, person{};  ///< ids of the attempt and of the person (Person::id)
    std::string why{};
  };
  struct Flagged {
    std::string attempt{}, person{};  ///< ids of the attempt and of the person (Person::id)
    std::vector<std::string> words{};
  };
  std::int64_t compared = 0;  ///< number of attempts compared
  std::vector<StoreDifference> differences{};
  std::vector<Left> left{};  ///< ended attempts that could not be recomputed, with the reason
  /// Values that were left out of the comparison: a text with value and reason, and the number of attempts concerned.
  std::map<std::string, int> notCompared{};
  /// Reasons why needle events were not computed again, and the number of attempts concerned.
  std::map<std::string, int> eventsNotCompared{};
  /// Attempts with implausible values, including those that could not be recomputed.
  std::vector<Flagged> implausible{};
};

/// Compares the stored values of an attempt with values that are recomputed from its recording, and adds the result to
/// `into`. Values count as equal if they agree within a billionth, since mathematical libraries differ in the last
/// digits. A metric is compared if its definition still has the stored version; outcome and points are compared if the
/// procedure still has the stored version. `events`: compares the needle events; empty: the recorded events are taken
/// as they are. Fails if the recording cannot be scored, or if cancelled.
Result<void> compareWithRecording(const AttemptFacts& stored, const std::filesystem::path& recording,
                                  RecomputedAttempts& into, const CompareEvents& events = {},
                                  const Progress& progress = {});

/// Compares all attempts of the database with their recordings; administrators only. Takes about a second for ten
/// attempts, and some seconds for each attempt if `events` compares the needle events.
Result<RecomputedAttempts> recomputeAttempts(const SignedIn& by, const CompareEvents& events, const Progress& progress);

/// Compares as recomputeAttempts() does, and also attempts with the audit log, and standings with attempts.
Result<RecomputedAttempts> compareDatabase(const SignedIn& by, const CompareEvents& events, const Progress& progress);

}  // namespace insonate
