#include "LevelRecord.h"
#include "LevelSentence.h"

#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/LcCusum.h>
#include <insonate/curriculum/Unlocking.h>

#include <algorithm>
#include <map>
#include <string_view>

namespace insonate {
namespace {

using Indices = std::map<std::string_view, std::size_t>;

Indices indicesOf(const Curriculum& curriculum) {
  Indices indices;
  for (std::size_t i = 0; i < curriculum.levels.size(); ++i) indices.emplace(curriculum.levels[i].name, i);
  return indices;
}

/// Lists, for each level, the level itself and all its direct and indirect prerequisites.
std::vector<std::vector<std::size_t>> foundations(const Curriculum& curriculum, const Indices& indices) {
  std::vector<std::vector<std::size_t>> all;
  for (std::size_t i = 0; i < curriculum.levels.size(); ++i) {
    std::vector<std::size_t> mine{i};
    for (const std::string& needed : curriculum.levels[i].prerequisites)
      for (const std::size_t j : all[indices.at(needed)])
        if (std::ranges::find(mine, j) == mine.end()) mine.push_back(j);
    all.push_back(std::move(mine));
  }
  return all;
}

/// Assumed time of each attempt (Unlocking.h).
std::vector<std::int64_t> believedTimes(std::span<const AttemptFacts> history, std::int64_t now_us) {
  std::vector<std::int64_t> times;
  const auto believable = [&](const AttemptFacts& attempt) {
    return attempt.state != AttemptState::Open && attempt.begun_us >= 0 && attempt.begun_us <= now_us;
  };
  const auto first = std::ranges::find_if(history, believable);
  std::int64_t time = first == history.end() ? std::max<std::int64_t>(now_us, 0) : first->begun_us;
  for (const AttemptFacts& attempt : history) {
    if (believable(attempt)) time = std::max(time, attempt.begun_us);
    times.push_back(time);
  }
  return times;
}

std::vector<LevelRecord> recordsOf(const Curriculum& curriculum, const Indices& indices,
                                   std::span<const AttemptFacts> history, std::int64_t now_us) {
  const auto built = foundations(curriculum, indices);
  const std::vector<std::int64_t> times = believedTimes(history, now_us);
  std::vector<LevelRecord> records(curriculum.levels.begin(), curriculum.levels.end());
  for (std::size_t i = 0; i < history.size(); ++i) {
    const AttemptFacts& attempt = history[i];
    const Level* at = levelOf(curriculum, attempt);
    if (!at || !isCounted(attempt, *at)) continue;
    const auto level = indices.find(attempt.level);
    for (const std::size_t practised : built[level->second]) records[practised].practised(times[i]);
    records[level->second].take(attempt, times[i]);
  }
  for (LevelRecord& record : records) record.lapseByDays(std::max(now_us, record.lastPractice_us()));
  return records;
}

/// State of a level that affects the levels built on it.
struct Gate {
  bool reached = false;  ///< mastered once, with its prerequisites
  std::int64_t reachedSince_us = 0;
  bool mastered = false;  ///< now
  std::int64_t since_us = 0;
};

/// The prerequisites of a level together.
struct Prerequisites {
  Gate all{true, 0, true, 0};
  std::vector<Obstacle> missing;
};

Prerequisites prerequisitesOf(const Level& level, const Indices& indices, const std::vector<Gate>& gates,
                              const std::vector<LevelRecord>& records) {
  Prerequisites needed;
  for (const std::string& name : level.prerequisites) {
    const std::size_t i = indices.at(name);
    needed.all.reached &= gates[i].reached, needed.all.mastered &= gates[i].mastered;
    needed.all.reachedSince_us = std::max(needed.all.reachedSince_us, gates[i].reachedSince_us);
    needed.all.since_us = std::max(needed.all.since_us, gates[i].since_us);
    if (!gates[i].mastered) needed.missing.push_back({&records[i], gates[i].reached});
  }
  return needed;
}

LevelState stateOf(LevelRecord::Skill skill, const Gate& prerequisites) {
  using enum LevelRecord::Skill;
  if (skill == Mastered && prerequisites.reached) return LevelState::Mastered;
  if (!prerequisites.mastered) return LevelState::Locked;
  return skill == Lapsed ? LevelState::Lapsed : LevelState::Open;
}

std::optional<std::int64_t> sinceOf(const LevelRecord& record, LevelState state, const Prerequisites& needed) {
  if (state == LevelState::Mastered) return std::max(record.skillSince_us(), needed.all.reachedSince_us);
  if (state == LevelState::Lapsed) return std::max(record.skillSince_us(), needed.all.since_us);
  if (state == LevelState::Open && !record.level().prerequisites.empty()) return needed.all.since_us;
  return std::nullopt;
}

/// Time at which passing days alone change the state, or change the number of days in a lapsed level's sentence.
std::int64_t untilOf(const LevelRecord& record, std::int64_t now_us) {
  const auto& days = record.level().mastery.lapsesAfter_days;
  const std::int64_t last_us = record.lastPractice_us();
  if (!days || record.skill() == LevelRecord::Skill::Never) return kForever_us;
  if (record.skill() == LevelRecord::Skill::Mastered) return last_us + *days * kDay_us + 1;
  return last_us + ((now_us - last_us) / kDay_us + 1) * kDay_us;
}

LevelProgress progressFrom(const LevelRecord& record) {
  LevelProgress progress;
  progress.level = record.level().name;
  progress.attempts = record.attempts(), progress.passes = record.passes();
  progress.consecutivePasses = record.consecutivePasses(), progress.lastPassed = record.lastPassed();
  progress.standardsMet = record.standardsMet();
  progress.cusum = record.cusum(), progress.cusumSignaled = record.cusumSignaled();
  return progress;
}

}  // namespace

int fewestAttempts(const MasteryRule& rule) {
  if (!rule.cusum) return rule.consecutivePasses;
  const LcCusum test{rule.cusum->acceptable, rule.cusum->unacceptable};
  return std::max(rule.consecutivePasses, test.fewestToSignal(rule.cusum->limit));
}

std::vector<LevelProgress> computeProgress(const Curriculum& curriculum, std::span<const AttemptFacts> history,
                                           std::int64_t now_us) {
  const Indices indices = indicesOf(curriculum);
  const std::vector<LevelRecord> records = recordsOf(curriculum, indices, history, now_us);
  std::vector<Gate> gates;
  std::vector<LevelProgress> all;
  for (const LevelRecord& record : records) {
    const Prerequisites needed = prerequisitesOf(record.level(), indices, gates, records);
    LevelProgress progress = progressFrom(record);
    progress.state = stateOf(record.skill(), needed.all);
    progress.since_us = sinceOf(record, progress.state, needed);
    progress.why = levelSentence(record, progress.state, needed.missing, now_us, LastAttempt::Stated);
    progress.summary = levelSentence(record, progress.state, needed.missing, now_us, LastAttempt::Omitted);
    progress.until_us = untilOf(record, now_us);
    gates.push_back({needed.all.reached && record.skill() != LevelRecord::Skill::Never,
                     std::max(record.firstMastered_us(), needed.all.reachedSince_us),
                     progress.state == LevelState::Mastered, progress.since_us.value_or(0)});
    all.push_back(std::move(progress));
  }
  return all;
}

}  // namespace insonate
