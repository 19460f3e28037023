#include <insonate/curriculum/Judgement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace insonate {
namespace {

/// procedure/AttemptMetrics.h: punctures of the skin.
constexpr std::string_view kSkinPunctures = "passes";

/// Values that are not finite count as not measured.
std::optional<double> finite(std::optional<double> value) {
  return value && std::isfinite(*value) ? value : std::nullopt;
}

bool isMet(const MetricStandard& standard, std::optional<double> value) {
  if (!value) return false;
  return standard.minimum ? *value >= *standard.minimum : standard.maximum && *value <= *standard.maximum;
}

/// A unit of metrics: the end of their ids, how it follows a number, and how it ends the texts of standards.
struct Unit {
  std::string_view id, sign, inText;
};
constexpr std::array kUnits{Unit{"_deg", "°", " (degrees)"}, Unit{"_s", " s", " (s)"}, Unit{"_mm", " mm", " (mm)"},
                            Unit{"_percent", " %", " (%)"},  Unit{"_N", " N", " (N)"}, Unit{"_ml", " ml", " (ml)"}};

const Unit* unitOf(std::string_view metric) {
  const auto found = std::ranges::find_if(kUnits, [&](const Unit& unit) { return metric.ends_with(unit.id); });
  return found == kUnits.end() ? nullptr : found;
}

std::string shown(double value, const Unit* unit = nullptr, int digits = 3) {
  char text[32];
  // Four digits before the point would become an exponent.
  if (digits == 3 && std::abs(value) >= 100 && std::abs(value) < 1e9)
    std::snprintf(text, sizeof text, "%.0f", value);
  else
    std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text + std::string(unit ? unit->sign : "");
}

/// A value that misses its limit never looks like the limit.
std::string shownBeside(double limit, double value, const Unit* unit = nullptr) {
  const std::string text = shown(value, unit);
  return text == shown(limit, unit) ? shown(value, unit, 6) : text;
}

/// The words of a metric's id, without its unit: "insertion angle" for insertion_angle_deg.
std::string metricWords(std::string_view id) {
  if (const Unit* unit = unitOf(id)) id.remove_suffix(unit->id.size());
  std::string words(id);
  std::ranges::replace(words, '_', ' ');
  return words;
}

std::string reasonOf(const MetricStandard& standard, std::optional<double> value) {
  // Without a value, the sentence of the standard would not be true: the angle was neither too flat nor too steep.
  if (!value) return "no data for " + metricWords(standard.metric) + (standard.critical ? " (must be met)" : "");
  const Unit* unit = unitOf(standard.metric);
  const double limit = standard.minimum ? *standard.minimum : *standard.maximum;
  std::string text = standard.otherwise;
  if (unit && text.ends_with(unit->inText)) text.resize(text.size() - unit->inText.size());
  return text + " (" + shownBeside(limit, *value, unit) + (standard.minimum ? ", at least " : ", at most ") +
         shown(limit, unit) + (standard.critical ? "; must be met)" : ")");
}

std::string listed(const std::vector<std::string>& reasons) {
  std::string list;
  for (const std::string& reason : reasons) list += (list.empty() ? "" : "; ") + reason;
  return list;
}

/// Value of any version of the definition; none if nothing was measured.
std::optional<double> skinPunctures(const AttemptFacts& attempt) {
  const auto fact = std::ranges::find(attempt.metrics, kSkinPunctures, &MetricFact::id);
  return fact == attempt.metrics.end() ? std::nullopt : finite(fact->value);
}

bool hasProof(const AttemptFacts& attempt) {
  return attempt.proof != AttemptProof::Unproven && attempt.proof != AttemptProof::Verifying;
}

/// Reason other than standards and points; empty if there is none.
std::string graveReason(const AttemptFacts& attempt) {
  if (attempt.criticalErrors == 1) return "there was a critical error";
  if (attempt.criticalErrors > 1) return "there were " + std::to_string(attempt.criticalErrors) + " critical errors";
  if (attempt.state != AttemptState::Completed)
    return hasBrokenOff(attempt) ? "it was abandoned: its recording broke off"
                                 : "it was abandoned with the needle in the skin";
  return attempt.succeeded ? "" : "it did not succeed";
}

}  // namespace

bool Judgement::reachesStandards(const PassRule& rule) const {
  return criticalMet && percentMet() >= rule.mastery_percent;
}

double Judgement::percentMet() const {
  return standardsMet.empty() ? 100 : 100.0 * met / static_cast<double>(standardsMet.size());
}

std::vector<std::string> missedStandards(const PassRule& rule, const AttemptFacts& attempt) {
  std::vector<std::string> missed;
  for (const bool critical : {true, false})
    for (const MetricStandard& standard : rule.standards) {
      const auto value = valueOf(attempt, standard.metric, standard.version);
      if (standard.critical != critical || isMet(standard, value)) continue;
      std::string reason = reasonOf(standard, value);
      // Two limits of one metric that was not measured are one reason.
      if (std::ranges::find(missed, reason) == missed.end()) missed.push_back(std::move(reason));
    }
  return missed;
}

std::optional<double> valueOf(const AttemptFacts& attempt, std::string_view metric, int version) {
  for (const MetricFact& fact : attempt.metrics)
    if (fact.id == metric && fact.version == version) return finite(fact.value);
  return std::nullopt;
}

bool isCounted(const AttemptFacts& attempt) {
  if (attempt.state == AttemptState::Completed) return true;
  return attempt.state == AttemptState::Abandoned && skinPunctures(attempt) != 0.0;
}

std::optional<double> pointsOf(const AttemptFacts& attempt) {
  return attempt.state == AttemptState::Abandoned ? std::nullopt : attempt.points;
}

bool hasBrokenOff(const AttemptFacts& attempt) {
  return attempt.state == AttemptState::Abandoned && !skinPunctures(attempt);
}

bool isSuccess(const AttemptFacts& attempt) {
  return attempt.state == AttemptState::Completed && attempt.succeeded;
}

const Level* levelOf(const Curriculum& curriculum, const AttemptFacts& attempt) {
  const Level* level = attempt.curriculum == curriculum.name ? curriculum.level(attempt.level) : nullptr;
  return level && level->procedure == attempt.procedure ? level : nullptr;
}

std::optional<bool> passedIn(const Curriculum& curriculum, const AttemptFacts& attempt) {
  const Level* level = levelOf(curriculum, attempt);
  return level && isCounted(attempt, *level) ? std::optional(judge(level->pass, attempt).passed) : std::nullopt;
}

Judgement judge(const PassRule& rule, const AttemptFacts& attempt) {
  Judgement judgement;
  judgement.standardsMet.reserve(rule.standards.size());
  for (const MetricStandard& standard : rule.standards) {
    judgement.standardsMet.push_back(isMet(standard, valueOf(attempt, standard.metric, standard.version)));
    judgement.met += judgement.standardsMet.back();
    if (standard.critical && !judgement.standardsMet.back()) judgement.criticalMet = false;
  }
  const auto points = finite(attempt.points);
  const bool pointsReached = !rule.minPoints || (points && *points >= *rule.minPoints);
  judgement.passed = graveReason(attempt).empty() && pointsReached && judgement.reachesStandards(rule);
  return judgement;
}

bool countsAsPractice(const AttemptFacts& attempt, const Level& level) {
  if (level.assistance != Assistance::Test) return false;
  using enum TestConditions;
  return attempt.testConditions == None || attempt.testConditions == Practice || attempt.testConditions == Undecided;
}

bool isCountedAtLevels(const AttemptFacts& attempt) {
  return isCounted(attempt) && !attempt.curriculum.empty() && attempt.testConditions != TestConditions::Practice &&
         attempt.testConditions != TestConditions::Undecided;
}

bool isInFigures(const AttemptFacts& attempt) {
  return isCounted(attempt) && skinPunctures(attempt) != 0.0 && (hasProof(attempt) || !attempt.succeeded);
}

bool waitsForAcceptance(const AttemptFacts& attempt) {
  return isCounted(attempt) && attempt.succeeded && attempt.proof == AttemptProof::Unproven;
}

bool isCounted(const AttemptFacts& attempt, const Level& level) {
  return isCounted(attempt) && !countsAsPractice(attempt, level) &&
         (hasProof(attempt) || !judge(level.pass, attempt).passed);
}

std::string reasonOfFailure(const PassRule& rule, const AttemptFacts& attempt) {
  const Judgement judgement = judge(rule, attempt);
  if (judgement.passed) return {};
  std::string grave = graveReason(attempt);
  std::string standards = listed(missedStandards(rule, attempt));
  // An attempt that broke off has no measured standards; listing all of them would inform nobody.
  if (attempt.state == AttemptState::Abandoned && attempt.metrics.empty()) return grave;
  if (!grave.empty()) return standards.empty() ? grave : grave + "; " + standards;
  if (!judgement.reachesStandards(rule)) return standards;
  const auto points = finite(attempt.points);
  return "it had " + (points ? shownBeside(*rule.minPoints, *points) : "no") + " points and " + shown(*rule.minPoints) +
         " are needed";
}

std::string outcomeWords(const AttemptFacts& attempt, const Curriculum* curriculum) {
  if (attempt.state == AttemptState::Open) return "Not ended";
  if (attempt.state == AttemptState::Voided) return "Voided";
  if (!isCounted(attempt)) return "Abandoned before skin puncture; does not count";
  const Level* level = curriculum ? levelOf(*curriculum, attempt) : nullptr;
  if (!level && hasBrokenOff(attempt)) return "Abandoned: the recording stopped early";
  if (!level)
    return attempt.state == AttemptState::Abandoned ? "Abandoned" : attempt.succeeded ? "Succeeded" : "Did not succeed";
  const std::string reason = reasonOfFailure(level->pass, attempt);
  if (countsAsPractice(attempt, *level))
    return "Practice, the test was not open: would " + (reason.empty() ? "pass" : "fail because " + reason);
  if (!isCounted(attempt, *level))
    return attempt.proof == AttemptProof::Verifying ? "Would pass; counts when the server has verified it"
                                                    : "Would pass, not proven; does not count";
  const bool isAlone =
      level->assistance == Assistance::Test && attempt.testConditions == TestConditions::SelfAdministered;
  return (reason.empty() ? "Passed" : "Failed because " + reason) + (isAlone ? " (self-administered)" : "");
}

}  // namespace insonate
