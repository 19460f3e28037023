#include "LevelWords.h"

#include <insonate/curriculum/Judgement.h>
#include <insonate/procedure/AttemptMetrics.h>
#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/Text.h>

#include <algorithm>

namespace insonate::train {
namespace {

const MetricDefinition* definitionOf(const std::string& id) {
  const auto found = std::ranges::find(metricTable(), id, &MetricDefinition::id);
  return found == metricTable().end() ? nullptr : &*found;
}

/// As elsewhere in the window; of a metric that is gone, its name.
QString nameOf(const MetricStandard& standard) {
  const MetricDefinition* known = definitionOf(standard.metric);
  return known ? ui::titleOf(known->metric) : ui::qt(standard.metric);
}

QString valueFor(const MetricStandard& standard, std::optional<double> value) {
  const MetricDefinition* known = definitionOf(standard.metric);
  if (known) return ui::valueOf(known->metric, value);
  return value ? QString::number(*value) : tr("n/a");
}

/// With the digits that the curriculum gives it.
QString boundOf(const MetricStandard& standard) {
  const MetricDefinition* known = definitionOf(standard.metric);
  const QString unit = known ? ui::qt(known->unit) : QString();
  const QString number = QString::number(standard.minimum ? *standard.minimum : standard.maximum.value_or(0), 'g', 6);
  const QString bound = unit.isEmpty()                 ? number
                        : unit == QLatin1String("deg") ? number + QStringLiteral("°")
                                                       : number + QLatin1Char(' ') + unit;
  const QString limit = standard.minimum ? tr("at least %1").arg(bound) : tr("at most %1").arg(bound);
  return standard.critical ? tr("%1, must be met").arg(limit) : limit;
}

const LevelProgress* find(std::span<const LevelProgress> all, const std::string& level) {
  const auto found = std::ranges::find(all, level, &LevelProgress::level);
  return found == all.end() ? nullptr : &*found;
}

/// Standards that were missed are told by themselves.
QString headlineFor(const Level& level, const AttemptFacts& attempt, bool passed) {
  const PassRule& rule = level.pass;
  if (!isCounted(attempt)) return tr("Does not count: the attempt was abandoned before skin puncture");
  if (countsAsPractice(attempt, level))
    return attempt.testConditions == TestConditions::Undecided
               ? tr("Pending: it is not yet confirmed that the test was open")
           : judge(rule, attempt).passed
               ? tr("Practice, does not count: the test was not open. The attempt would have passed")
               : tr("Practice, does not count: the test was not open. The attempt would not have passed");
  if (!passed && attempt.state == AttemptState::Completed && !judge(rule, attempt).reachesStandards(rule))
    return attempt.succeeded ? tr("Not passed") : tr("Not passed: the attempt did not succeed");
  if (!passed && judge(rule, attempt).passed)
    return tr(
        "This attempt does not count yet: the database could not be reached when the attempt began. An instructor can "
        "accept the attempt");
  return passed ? tr("Passed") : tr("Not passed: %1").arg(ui::qt(reasonOfFailure(rule, attempt)));
}

/// Sentence about a change of another level than the practiced one.
QString changeOf(const Level& level, LevelState before, LevelState after) {
  if (before == after) return {};
  if (after == LevelState::Locked) return tr("The level '%1' is locked now.").arg(ui::qt(level.title));
  if (after == LevelState::Open) return tr("The level '%1' is unlocked now.").arg(ui::qt(level.title));
  return after == LevelState::Mastered ? tr("The level '%1' is mastered now.").arg(ui::qt(level.title))
                                       : tr("The level '%1' has lapsed.").arg(ui::qt(level.title));
}

}  // namespace

StateWords displayText(LevelState state) {
  switch (state) {
    case LevelState::Locked:
      return {QStringLiteral("○"), tr("locked")};
    case LevelState::Open:
      return {QStringLiteral("▶"), tr("unlocked")};
    case LevelState::Mastered:
      return {QStringLiteral("✓"), tr("mastered")};
    case LevelState::Lapsed:
      break;
  }
  return {QStringLiteral("▲"), tr("lapsed")};
}

QString dotsOf(const Level& level, const LevelProgress& progress) {
  const int needed = level.mastery.consecutivePasses, made = std::min(progress.consecutivePasses, needed);
  constexpr int kMaxDots = 10;
  if (needed > kMaxDots) return tr("%1 of %2").arg(made).arg(needed);
  return QString(made, QChar(0x25CF)) + QString(needed - made, QChar(0x25CB));
}

QString limitOf(const MetricStandard& standard) {
  return QStringLiteral("%1: %2").arg(nameOf(standard), boundOf(standard));
}

QString comparedWith(const MetricStandard& standard, const AttemptFacts& attempt) {
  const auto value = valueOf(attempt, standard.metric, standard.version);
  return QStringLiteral("%1: %2, %3").arg(nameOf(standard), valueFor(standard, value), boundOf(standard));
}

QString masteryOf(const Level& level) {
  const MasteryRule& rule = level.mastery;
  QStringList parts{rule.consecutivePasses == 1 ? tr("one passed attempt")
                                                : tr("%1 consecutive passes").arg(rule.consecutivePasses)};
  if (rule.cusum) parts << tr("the learning curve score LC-CUSUM reaches %1").arg(rule.cusum->limit, 0, 'f', 2);
  const int fewest = fewestAttempts(rule);
  if (fewest > rule.consecutivePasses) parts << tr("at least %1 attempts").arg(fewest);
  if (rule.lapsesAfter_days) parts << tr("the level lapses after %1 days without practice").arg(*rule.lapsesAfter_days);
  if (rule.lapsesAfter)
    parts << tr("the level lapses after %1 failures within %2 attempts")
                 .arg(rule.lapsesAfter->failures)
                 .arg(rule.lapsesAfter->within);
  return parts.join(QStringLiteral("; "));
}

QString passOf(const PassRule& rule) {
  QStringList parts{tr("completed and successful attempt without a critical error")};
  if (rule.minPoints) parts << tr("at least %1 points").arg(*rule.minPoints);
  if (!rule.standards.empty() && rule.mastery_percent < 100)
    parts << tr("at least %1 % of the standards met, including every one that must be met").arg(rule.mastery_percent);
  else if (!rule.standards.empty())
    parts << tr("all standards met");
  return parts.join(QStringLiteral(", "));
}

Verdict verdictOf(const Curriculum& curriculum, const Level& level, const AttemptFacts& attempt,
                  std::span<const LevelProgress> before, std::span<const LevelProgress> after) {
  const Judgement judgement = judge(level.pass, attempt);
  Verdict verdict;
  verdict.passed = judgement.passed && isCounted(attempt, level);
  verdict.headline = headlineFor(level, attempt, verdict.passed);
  for (std::size_t i = 0; i < level.pass.standards.size(); ++i)
    (judgement.standardsMet[i] ? verdict.met : verdict.missed) << comparedWith(level.pass.standards[i], attempt);
  if (const LevelProgress* now = find(after, level.name)) verdict.changes << ui::qt(now->summary);
  for (const Level& other : curriculum.levels) {
    const LevelProgress *was = find(before, other.name), *is = find(after, other.name);
    if (!was || !is || other.name == level.name) continue;
    if (const QString change = changeOf(other, was->state, is->state); !change.isEmpty()) verdict.changes << change;
  }
  return verdict;
}

QString outcomeOf(const Curriculum* curriculum, const AttemptFacts& attempt) {
  if (attempt.state == AttemptState::Voided) return tr("voided");
  if (attempt.state == AttemptState::Open) return tr("not ended");
  if (attempt.state == AttemptState::Abandoned) return tr("abandoned");
  const bool ours = curriculum && attempt.curriculum == curriculum->name && isCounted(attempt);
  const Level* level = ours ? curriculum->level(attempt.level) : nullptr;
  if (level && countsAsPractice(attempt, *level))
    return attempt.testConditions == TestConditions::Undecided ? tr("pending") : tr("practice (test not open)");
  if (level && !isCounted(attempt, *level))
    return attempt.proof == AttemptProof::Verifying ? tr("being verified") : tr("not proven");
  QString outcome = level && judge(level->pass, attempt).passed ? tr("passed") : tr("failed");
  if (level && level->assistance == Assistance::Test && attempt.testConditions == TestConditions::SelfAdministered)
    return tr("%1, self-administered").arg(outcome);
  if (level) return outcome;
  return attempt.level.empty() ? tr("free practice") : tr("completed");
}

}  // namespace insonate::train
