#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/Unlocking.h>

#include <QString>
#include <QStringList>
#include <span>
#include <vector>

namespace insonate::train {

/// Sign and word of a level's state.
struct StateWords {
  QString sign, word;
};
StateWords wordsOf(LevelState state);

/// "●●○": passes in a row, and how many there are to be.
QString dotsOf(const Level& level, const LevelProgress& progress);

/// "artery punctures: at most 0".
QString limitOf(const MetricStandard& standard);
/// "artery punctures: 1, at most 0", of an attempt.
QString comparedWith(const MetricStandard& standard, const AttemptFacts& attempt);
/// "3 passes in a row; the learning score LC-CUSUM reaches 4.07; at least 11 attempts; lapses after 90 days without
/// practice".
QString masteryOf(const Level& level);
/// Requirements of one attempt, without its standards: "completed, succeeded, without a critical error, ...".
QString passOf(const PassRule& rule);

/// Result of an attempt at a level by its rule, and the changes that it made.
struct Verdict {
  bool passed = false;
  QString headline{};  ///< "Passed", or why not
  QStringList met{};   ///< standards, with values
  QStringList missed{};
  QStringList changes{};  ///< sentences on the path of levels
};
Verdict verdictOf(const Curriculum& curriculum, const Level& level, const AttemptFacts& attempt,
                  std::span<const LevelProgress> before, std::span<const LevelProgress> after);

/// "passed", "failed", "abandoned", "free practice", "voided", "not ended".
QString outcomeOf(const Curriculum* curriculum, const AttemptFacts& attempt);

}  // namespace insonate::train
