#include "AttemptMaker.h"

#include <insonate/curriculum/Attention.h>
#include <insonate/curriculum/Standings.h>

#include <gtest/gtest.h>

#include <random>

namespace insonate {
namespace {

using test::attemptsAt;
using test::courseOf;
using test::kDay_us;
using test::kNoon_us;
using test::levelNamed;

TEST(Attention, NamesWhoHasNotBegunIsIdleOrHasToPractice) {
  const std::int64_t now_us = kNoon_us + 100 * kDay_us;
  Member member;
  EXPECT_EQ(attentionOf(member, now_us), Attention::NotBegun);
  EXPECT_EQ(displayText(Attention::NotBegun, member, now_us), "not begun");

  member.lastAttempt_us = now_us - 20 * kDay_us;
  EXPECT_EQ(attentionOf(member, now_us), Attention::None);
  EXPECT_EQ(displayText(Attention::None, member, now_us), "");
  member.lastAttempt_us = now_us - 36 * kDay_us;
  EXPECT_EQ(attentionOf(member, now_us), Attention::Idle);
  EXPECT_EQ(displayText(Attention::Idle, member, now_us), "idle for 5 weeks");

  member.standing = Standing{.level = "", .mastered = 3, .until_us = now_us + 9 * kDay_us};
  EXPECT_EQ(attentionOf(member, now_us), Attention::Idle) << "an outdated standing tells nothing";
  member.standingIsCurrent = true;
  EXPECT_EQ(attentionOf(member, now_us), Attention::Due) << "all is mastered, but not for long";
  EXPECT_EQ(displayText(Attention::Due, member, now_us), "practice due in 9 days");
  member.standing->until_us = now_us + 15 * kDay_us;
  EXPECT_EQ(attentionOf(member, now_us), Attention::None);
  member.standing->until_us = kForever_us;
  EXPECT_EQ(attentionOf(member, now_us), Attention::None);

  member.standing->concern = Concern::Stuck;
  EXPECT_EQ(attentionOf(member, now_us), Attention::Stuck);
  member.standing->concern = Concern::Slipped;
  EXPECT_EQ(displayText(attentionOf(member, now_us), member, now_us), "level lapsed");
  EXPECT_GT(Attention::Lapsed, Attention::Stuck) << "most urgent";
  member.person.disabled = true;
  EXPECT_EQ(attentionOf(member, now_us), Attention::None) << "a person who has left, or was erased";
}

TEST(Standings, NameTheFirstLevelThatIsDueAndWhy) {
  Curriculum course = courseOf({levelNamed("a", 1), levelNamed("b", 2, {"a"})});
  course.levels[0].mastery.lapsesAfter_days = 30;
  auto history = attemptsAt("a", "P");
  std::int64_t now_us = kNoon_us + kDay_us;
  auto progress = computeProgress(course, history, now_us);
  Standing standing = computeStanding(course, history, progress, now_us, 5);
  EXPECT_EQ(standing.curriculum, course.name);
  EXPECT_EQ(standing.curriculumVersion, course.version);
  EXPECT_EQ(standing.changes, 5);
  EXPECT_EQ(standing.level, "b");
  EXPECT_EQ(standing.mastered, 1);
  EXPECT_EQ(standing.sentence, progress[1].why);

  now_us = kNoon_us + 60 * kDay_us;
  progress = computeProgress(course, history, now_us);
  standing = computeStanding(course, history, progress, now_us, 5);
  EXPECT_EQ(standing.level, "a") << "it has lapsed";
  EXPECT_EQ(standing.mastered, 0);

  course = courseOf({levelNamed("a", 1)});
  now_us = kNoon_us;
  progress = computeProgress(course, history, now_us);
  standing = computeStanding(course, history, progress, now_us, 5);
  EXPECT_EQ(standing.level, "");
  EXPECT_EQ(standing.mastered, 1);
  EXPECT_EQ(standing.sentence, "All levels are mastered.");
}

TEST(Standings, HoldUntilTheySay) {
  Curriculum course = courseOf({levelNamed("a", 2), levelNamed("b", 1, {"a"}), levelNamed("c", 1)});
  course.levels[0].mastery.lapsesAfter_days = 3;
  course.levels[0].mastery.lapsesAfter = FailureRule{2, 3};
  course.levels[2].mastery.lapsesAfter_days = 7;
  std::mt19937 random(8);
  const auto below = [&](std::int64_t most) { return std::int64_t(random() % std::uint64_t(most)); };
  int ended = 0;
  for (int career = 0; career < 2000; ++career) {
    std::vector<AttemptFacts> history;
    for (std::int64_t i = below(9); i > 0; --i) {
      const std::string level(1, char('a' + below(3)));
      const std::int64_t begun_us = kNoon_us + below(20 * 24) * (kDay_us / 24) - 5 * kDay_us;
      history.push_back(below(4) > 0 ? test::passedAttempt(level, begun_us) : test::failedAttempt(level, begun_us));
      if (below(8) == 0) history.back().state = AttemptState::Open;
    }
    const auto at = [&](std::int64_t now_us) {
      return computeStanding(course, history, computeProgress(course, history, now_us), now_us, 1);
    };
    const std::int64_t now_us = kNoon_us + below(15 * kDay_us);
    const Standing kept = at(now_us);
    ASSERT_LT(now_us, kept.until_us);
    for (int i = 0; i < 5; ++i) {
      const std::int64_t max_us = std::min(kept.until_us, now_us + 40 * kDay_us) - now_us;
      Standing later = at(i == 0 ? now_us + max_us - 1 : now_us + below(max_us));
      later.from_us = kept.from_us, later.until_us = kept.until_us;
      ASSERT_EQ(later, kept) << kept.sentence << " became " << later.sentence;
    }
    if (kept.until_us == kForever_us) continue;
    Standing after = at(kept.until_us);
    after.from_us = kept.from_us, after.until_us = kept.until_us;
    ended += after != kept;
  }
  EXPECT_GT(ended, 200) << "or nothing ever ends, and this shows nothing";
}

}  // namespace
}  // namespace insonate
