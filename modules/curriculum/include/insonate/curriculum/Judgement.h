#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Curriculum.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Result of comparing one attempt with a level's conditions for passing (PassRule).
struct Judgement {
  bool passed = false;
  std::vector<bool> standardsMet{};  ///< for each of PassRule::standards, in their order: true if it is met
  int met = 0;                       ///< number of standards that are met
  bool criticalMet = true;           ///< true: all critical standards are met

  /// Returns the percentage of standards that are met; 100 if there are none.
  double percentMet() const;
  bool reachesStandards(const PassRule& rule) const;
};

/// Tells whether an attempt counts in statistics and progress. An attempt counts if it was completed, if the trainee
/// abandoned it, or if its recording broke off. An attempt does not count if it is open, was voided, or was abandoned
/// before the needle reached the skin (its metric "passes" is 0). An attempt whose recording broke off counts even
/// without measured values; otherwise trainees could exclude an attempt by ending the program. If a device caused the
/// end, an instructor can void the attempt.
bool isCounted(const AttemptFacts& attempt);

/// Returns the points of an attempt; none if it was abandoned, since what was not done costs no points.
std::optional<double> pointsOf(const AttemptFacts& attempt);

/// Tells whether an attempt was abandoned without any measured value, because its recording broke off (crash, power
/// failure, full disk).
bool hasBrokenOff(const AttemptFacts& attempt);

/// Tells whether an attempt was completed and was a success by the rules of the procedure. False for every abandoned
/// attempt, even if an older program version stored it as a success.
bool isSuccess(const AttemptFacts& attempt);

/// Returns the level of a curriculum for which an attempt was made, in any version of the curriculum. Null for attempts
/// in free practice or of another curriculum, and if the curriculum has no such level or the level has another
/// procedure.
const Level* levelOf(const Curriculum& curriculum, const AttemptFacts& attempt);

/// Tells whether an attempt passed its level by a curriculum's rules. Empty if the attempt has no level there
/// (levelOf() is null) or does not count.
std::optional<bool> passedIn(const Curriculum& curriculum, const AttemptFacts& attempt);

/// Tells whether an attempt at a test is practice: no instructor had opened the test for the person
/// (AttemptFacts::testConditions). An attempt that was made before the level became a test is practice, too.
bool countsAsPractice(const AttemptFacts& attempt, const Level& level);

/// Tells whether an attempt counts at a level. The attempt must count in general (isCounted(attempt)) and not be
/// practice. A passed attempt must also have a proof (neither Unproven nor Verifying). Failed attempts count without
/// proof; otherwise trainees could exclude them.
bool isCounted(const AttemptFacts& attempt, const Level& level);

/// Tells whether an attempt counts in general and was made at a level; false for free practice, and for a test that was
/// made while no instructor had opened it.
bool isCountedAtLevels(const AttemptFacts& attempt);

/// Tells whether the values of an attempt enter means and learning curves: it counts in general, the needle punctured
/// the skin, and a success has a proof. An attempt without a puncture has no complications, and would look like an
/// expert's; a success without proof may be another person's.
bool isInFigures(const AttemptFacts& attempt);

/// Tells whether a success without proof waits for an instructor, who accepts or voids it.
bool waitsForAcceptance(const AttemptFacts& attempt);

Judgement judge(const PassRule& rule, const AttemptFacts& attempt);

/// Returns the value of a metric in an attempt, if it was measured by this version of the metric's definition; empty if
/// missing or not finite.
std::optional<double> valueOf(const AttemptFacts& attempt, std::string_view metric, int version);

/// Returns a description of each standard that the attempt does not meet, critical standards first: "the artery was
/// punctured (1, at most 0; must be met)", or "no data for insertion angle" if the metric was not measured. An
/// attempt that passes may miss some standards.
std::vector<std::string> missedStandards(const PassRule& rule, const AttemptFacts& attempt);

/// Returns why an attempt does not pass, worded to follow "failed because": a critical error or no success, and each
/// missed standard; without any of these, too few points. "" if the attempt passes.
std::string reasonOfFailure(const PassRule& rule, const AttemptFacts& attempt);

/// Returns the outcome of an attempt in words: "Passed", "Failed because ...", "Voided", by the rule of its level. An
/// attempt without a level in `curriculum`, which may be null, has "Succeeded", "Did not succeed" or "Abandoned". A
/// practice attempt at a test has "Practice, the test was not open: would pass" or "... would fail because ..."; "
/// (self-administered)" is added to the outcome of a test that the person took alone.
std::string outcomeWords(const AttemptFacts& attempt, const Curriculum* curriculum);

}  // namespace insonate
