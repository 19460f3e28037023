#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Curriculum.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// One attempt beside a level's rule.
struct Judgement {
  bool passed = false;
  std::vector<bool> standardsMet{};  ///< in the order of PassRule::standards
  int met = 0;                       ///< how many of them
  bool criticalMet = true;           ///< each critical one

  /// Percentage of standards met; 100 if there are none.
  double percentMet() const;
  bool reachesStandards(const PassRule& rule) const;
};

/// Tells whether an attempt counts: a completed one, and one that the trainee abandoned or whose recording broke off.
/// An open or voided attempt does not count, nor one abandoned before the skin (its metric "passes" is 0): nothing was
/// tried. A recording that broke off without a measurement counts: a trainee who ends the program must not choose
/// which attempts count. An instructor voids the attempt if the device was to blame.
bool counts(const AttemptFacts& attempt);

/// Tells whether an attempt was abandoned without any measurement: its recording broke off (crash, power, full disk).
bool hasBrokenOff(const AttemptFacts& attempt);

/// Tells whether an attempt was completed and reached its aim. An abandoned attempt never did, although an older
/// program may have stored it as a success.
bool isSuccess(const AttemptFacts& attempt);

/// The level of a curriculum for which an attempt was made, in any version of it; null in free practice, for another
/// curriculum's attempts, and where level or procedure are not the curriculum's.
const Level* levelOf(const Curriculum& curriculum, const AttemptFacts& attempt);

/// Tells whether an attempt passed its level under a curriculum's rules. Empty if there is nothing to pass: levelOf()
/// is null, or the attempt does not count.
std::optional<bool> passedIn(const Curriculum& curriculum, const AttemptFacts& attempt);

/// Tells whether an attempt counts at a level with this rule: counts() holds and, if the attempt passes, there is
/// proof of it. An unproven attempt can fail but cannot pass; otherwise trainees could choose which attempts count.
bool counts(const AttemptFacts& attempt, const PassRule& rule);

Judgement judge(const PassRule& rule, const AttemptFacts& attempt);

/// The attempt's value of a metric, by this version of its definition; empty if missing or not finite.
std::optional<double> valueOf(const AttemptFacts& attempt, std::string_view metric, int version);

/// Each standard that the attempt does not meet, critical ones first: "the artery was punctured (1, at most 0: a
/// critical error)". An attempt that passes may miss some.
std::vector<std::string> missedStandards(const PassRule& rule, const AttemptFacts& attempt);

/// Why an attempt does not pass, as it follows "failed because": a critical error or no success, and each standard that
/// was missed; else the points. "" where it passes.
std::string reasonOfFailure(const PassRule& rule, const AttemptFacts& attempt);

}  // namespace insonate
