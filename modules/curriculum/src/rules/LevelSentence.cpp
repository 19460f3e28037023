#include "LevelSentence.h"

#include <insonate/curriculum/Judgement.h>

#include <algorithm>
#include <cstdio>

namespace insonate {
namespace {

std::string counted(std::int64_t number, const std::string& noun) {
  return std::to_string(number) + " " + noun + (number == 1 ? "" : "s");
}

/// Passed attempts, not passes of the needle.
std::string inARow(int passes) {
  return passes == 1 ? "one passed attempt" : counted(passes, "passed attempt") + " in a row";
}

/// Progress of the consecutive passes: "2 of 3 passed attempts in a row".
std::string rowSoFar(const LevelRecord& record) {
  const int needed = record.level().mastery.consecutivePasses;
  if (record.consecutivePasses() >= needed) return inARow(record.consecutivePasses());
  return needed == 1 ? "no passed attempt yet" : std::to_string(record.consecutivePasses()) + " of " + inARow(needed);
}

std::string score(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

/// "; the learning score (LC-CUSUM) is 1.27 of 2.50", if the level requires it.
std::string cusumSoFar(const LevelRecord& record) {
  const auto& rule = record.level().mastery.cusum;
  if (!rule || record.cusum().empty()) return {};
  return "; the learning score (LC-CUSUM) " +
         (record.cusumSignaled() ? "has reached " + score(rule->limit)
                                 : "is " + score(record.cusum().back()) + " of " + score(rule->limit));
}

std::string lastAttempt(const LevelRecord& record, LastAttempt last) {
  if (!record.last() || last == LastAttempt::Omitted) return {};
  if (record.lastPassed()) {
    std::string text = "; the last attempt passed";
    for (const std::string& missed : missedStandards(record.level().pass, *record.last()))
      text += (text.ends_with("passed") ? " and missed: " : "; ") + missed;
    return text;
  }
  return "; the last attempt failed because " + reasonOfFailure(record.level().pass, *record.last());
}

std::string lockedSentence(const LevelRecord& record, const std::vector<Obstacle>& obstacles) {
  std::string first, renewed;
  for (const Obstacle& obstacle : obstacles) {
    std::string& names = obstacle.lapsed ? renewed : first;
    names += (names.empty() ? "'" : ", '") + obstacle.record->level().title + "'";
    if (!obstacle.lapsed && obstacles.size() == 1) names += " (" + rowSoFar(*obstacle.record) + ")";
  }
  std::string text = "Locked: ";
  if (!first.empty()) text += "master " + first + " first";
  if (!renewed.empty()) text += (first.empty() ? "renew " : "; renew ") + renewed + " first, which lapsed";
  if (record.consecutivePasses() > 0) text += "; " + inARow(record.consecutivePasses()) + " made here will count then";
  return text + ".";
}

std::string openSentence(const LevelRecord& record, LastAttempt last) {
  const MasteryRule& rule = record.level().mastery;
  if (record.attempts() > 0)
    return "Unlocked: " + rowSoFar(record) + cusumSoFar(record) + lastAttempt(record, last) + ".";
  return "Unlocked: no attempt counts yet; " + inARow(rule.consecutivePasses) +
         (rule.consecutivePasses == 1 ? " masters" : " master") + " it" +
         (rule.cusum ? ", with a learning score (LC-CUSUM) of " + score(rule.cusum->limit) + ": at least " +
                           counted(fewestAttempts(rule), "attempt")
                     : "") +
         ".";
}

/// "2 failures within 3 attempts"
std::string failures(const FailureRule& rule) {
  return counted(rule.failures, "failure") + " within " +
         (rule.within == 1 ? "one attempt" : counted(rule.within, "attempt"));
}

std::string masteredSentence(const LevelRecord& record, std::int64_t now_us, LastAttempt last) {
  std::string text = "Mastered with " + inARow(record.level().mastery.consecutivePasses) + cusumSoFar(record);
  if (!record.lastPassed()) text += lastAttempt(record, last);
  if (const int failed = record.failuresSinceMastery(); failed > 0)
    text +=
        "; " + failures(*record.level().mastery.lapsesAfter) + " let it lapse, " + std::to_string(failed) + " so far";
  if (const auto& days = record.level().mastery.lapsesAfter_days)
    text += "; it lapses after " + counted(*days, "day") + " without practice, " +
            counted(*days - (now_us - record.lastPractice_us()) / kDay_us, "day") + " from now";
  return text + ".";
}

std::string lapsedSentence(const LevelRecord& record, std::int64_t now_us, LastAttempt last) {
  const MasteryRule& rule = record.level().mastery;
  std::string text = "Lapsed: ";
  if (record.cause() == LevelRecord::Cause::Failures)
    text += failures(*rule.lapsesAfter);
  else
    text += "more than " + counted(*rule.lapsesAfter_days, "day") + " without practice";
  const bool sinceThen = record.consecutivePasses() > 0 || record.lastPractice_us() >= record.skillSince_us();
  if (!sinceThen) text += " (" + counted((now_us - record.lastPractice_us()) / kDay_us, "day") + ")";
  text += "; " + inARow(rule.consecutivePasses) + (rule.consecutivePasses == 1 ? " renews" : " renew") + " it";
  if (record.consecutivePasses() > 0) text += ", " + std::to_string(record.consecutivePasses()) + " so far";
  return text + (record.lastPassed() ? "" : lastAttempt(record, last)) + ".";
}

}  // namespace

std::string levelSentence(const LevelRecord& record, LevelState state, const std::vector<Obstacle>& obstacles,
                          std::int64_t now_us, LastAttempt last) {
  switch (state) {
    case LevelState::Locked:
      return lockedSentence(record, obstacles);
    case LevelState::Open:
      return openSentence(record, last);
    case LevelState::Mastered:
      return masteredSentence(record, now_us, last);
    case LevelState::Lapsed:
      break;
  }
  return lapsedSentence(record, now_us, last);
}

}  // namespace insonate
