#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Curriculum.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Comparison of one attempt with a level's rule.
struct Judgement {
  bool passed = false;
  std::vector<bool> standardsMet{};  ///< same order as PassRule::standards
  int met = 0;                       ///< number of standards met
  bool criticalMet = true;           ///< all critical standards are met

  /// Percentage of standards met; 100 if there are none.
  double percentMet() const;
  bool reachesStandards(const PassRule& rule) const;
};

/// Tells whether an attempt counts. An attempt counts if it was completed, if the trainee abandoned it, or if its
/// recording broke off. An open or voided attempt does not count, and neither does an attempt abandoned before the
/// needle reached the skin (its metric "passes" is 0). A recording that broke off without a measurement counts: a
/// trainee who ends the program must not choose which attempts count. An instructor voids the attempt if the device was
/// to blame.
bool counts(const AttemptFacts& attempt);

/// Tells whether an attempt was abandoned without any measurement: its recording broke off (crash, power, full disk).
bool hasBrokenOff(const AttemptFacts& attempt);

/// Tells whether an attempt was completed and reached its aim. False for every abandoned attempt, even if an older
/// program stored it as a success.
bool isSuccess(const AttemptFacts& attempt);

/// Returns the level of a curriculum for which an attempt was made, in any version of the curriculum. Null in free
/// practice, for attempts of another curriculum, and if the curriculum has no such level or the level has another
/// procedure.
const Level* levelOf(const Curriculum& curriculum, const AttemptFacts& attempt);

/// Tells whether an attempt passed its level under a curriculum's rules. Empty if there is nothing to pass: levelOf()
/// is null, or the attempt does not count.
std::optional<bool> passedIn(const Curriculum& curriculum, const AttemptFacts& attempt);

/// Tells whether an attempt counts at a level with this rule: counts() holds and, if the attempt passes, there is
/// proof of it. An unproven attempt can fail but cannot pass; otherwise trainees could choose which attempts count.
bool counts(const AttemptFacts& attempt, const PassRule& rule);

Judgement judge(const PassRule& rule, const AttemptFacts& attempt);

/// Value of a metric in an attempt, measured by this version of the metric's definition; empty if missing or not
/// finite.
std::optional<double> valueOf(const AttemptFacts& attempt, std::string_view metric, int version);

/// Describes each standard that the attempt does not meet, critical standards first: "the artery was punctured (1, at
/// most 0: a critical error)". An attempt that passes may miss some standards.
std::vector<std::string> missedStandards(const PassRule& rule, const AttemptFacts& attempt);

/// Reason why an attempt does not pass, worded to follow "failed because": a critical error or no success, and each
/// missed standard; if there is none of these, the points. "" if the attempt passes.
std::string reasonOfFailure(const PassRule& rule, const AttemptFacts& attempt);

}  // namespace insonate
