#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Curriculum.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace insonate::test {

inline constexpr std::int64_t kDay_us = 86'400'000'000;
/// 2026-11-22, 12:00 UTC.
inline constexpr std::int64_t kNoon_us = 1'795'348'800'000'000;

/// A completed, successful attempt at level `level` of the curriculum "course".
inline AttemptFacts passedAttempt(const std::string& level, std::int64_t begun_us = kNoon_us) {
  AttemptFacts attempt;
  attempt.id = "1c2f8f6e-6a5e-4b52-9c3e-6a1c55d1e0aa";
  attempt.person = "p";
  attempt.curriculum = "course", attempt.curriculumVersion = 1;
  attempt.level = level, attempt.procedure = "line";
  attempt.begun_us = begun_us;
  attempt.length_us = 60'000'000;
  attempt.state = AttemptState::Completed;
  attempt.succeeded = true;
  attempt.proof = AttemptProof::Proven;
  return attempt;
}

inline AttemptFacts failedAttempt(const std::string& level, std::int64_t begun_us = kNoon_us) {
  AttemptFacts attempt = passedAttempt(level, begun_us);
  attempt.succeeded = false;
  return attempt;
}

/// One attempt an hour: P passed, F failed.
inline std::vector<AttemptFacts> attemptsAt(const std::string& level, const std::string& outcomes,
                                            std::int64_t begun_us = kNoon_us) {
  std::vector<AttemptFacts> attempts;
  for (const char outcome : outcomes) {
    attempts.push_back(outcome == 'P' ? passedAttempt(level, begun_us) : failedAttempt(level, begun_us));
    begun_us += kDay_us / 24;
  }
  return attempts;
}

inline Level levelNamed(const std::string& name, int consecutivePasses,
                        const std::vector<std::string>& prerequisites = {}) {
  Level level;
  level.name = name, level.title = "Level " + name, level.about = "About.";
  level.caseName = "textbook", level.procedure = "line";
  level.prerequisites = prerequisites;
  level.mastery.consecutivePasses = consecutivePasses;
  return level;
}

inline Curriculum courseOf(const std::vector<Level>& levels) {
  Curriculum course;
  course.name = "course", course.title = "A course";
  course.levels = levels;
  return course;
}

}  // namespace insonate::test
