#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/Unlocking.h>

#include <QString>
#include <QStringList>
#include <span>
#include <vector>

namespace insonate::train {

/// Symbol and word for a level's state.
struct StateWords {
  QString sign, word;
};
StateWords displayText(LevelState state);

/// Returns one dot for each required consecutive pass, filled for those achieved: "●●○".
QString dotsOf(const Level& level, const LevelProgress& progress);

/// Describes a standard: "artery punctures: at most 0".
QString limitOf(const MetricStandard& standard);
/// Compares an attempt's value with a standard: "artery punctures: 1, at most 0".
QString comparedWith(const MetricStandard& standard, const AttemptFacts& attempt);
/// Describes the rules for mastery and lapse: "3 passes in a row; the learning score LC-CUSUM reaches 4.07; at least 11
/// attempts; the level lapses after 90 days without practice".
QString masteryOf(const Level& level);
/// Describes the requirements on one attempt, without its metric standards: "completed and successful attempt
/// without a critical error, ...".
QString passOf(const PassRule& rule);

/// Result of an attempt by the rule of its level, and the resulting changes of the user's progress.
struct Verdict {
  bool passed = false;
  QString headline{};  ///< "Passed", or the reason why the attempt did not pass
  QStringList met{};   ///< sentences with the standards that were met, and the values
  QStringList missed{};
  QStringList changes{};  ///< sentences about changes in the learning path
};
Verdict verdictOf(const Curriculum& curriculum, const Level& level, const AttemptFacts& attempt,
                  std::span<const LevelProgress> before, std::span<const LevelProgress> after);

/// Returns "passed", "failed", "abandoned", "free practice", "voided" or "not ended".
QString outcomeOf(const Curriculum* curriculum, const AttemptFacts& attempt);

}  // namespace insonate::train
