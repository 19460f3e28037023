#include "AttemptMaker.h"

#include <insonate/curriculum/Standings.h>

#include <gtest/gtest.h>

namespace insonate {
namespace {

using test::attemptsAt;
using test::courseOf;
using test::kDay_us;
using test::kNoon_us;
using test::levelNamed;

TEST(Standings, NameTheFirstLevelThatIsDueAndWhy) {
  Curriculum course = courseOf({levelNamed("a", 1), levelNamed("b", 2, {"a"})});
  course.levels[0].mastery.lapsesAfter_days = 30;
  auto history = attemptsAt("a", "P");
  auto progress = progressOf(course, history, kNoon_us + kDay_us);
  Standing standing = standingOf(course, progress, 5);
  EXPECT_EQ(standing.curriculum, course.name);
  EXPECT_EQ(standing.curriculumVersion, course.version);
  EXPECT_EQ(standing.changes, 5);
  EXPECT_EQ(standing.level, "b");
  EXPECT_EQ(standing.mastered, 1);
  EXPECT_EQ(standing.sentence, progress[1].why);

  progress = progressOf(course, history, kNoon_us + 60 * kDay_us);
  standing = standingOf(course, progress, 5);
  EXPECT_EQ(standing.level, "a") << "it has lapsed";
  EXPECT_EQ(standing.mastered, 0);

  course = courseOf({levelNamed("a", 1)});
  progress = progressOf(course, history, kNoon_us);
  standing = standingOf(course, progress, 5);
  EXPECT_EQ(standing.level, "");
  EXPECT_EQ(standing.mastered, 1);
  EXPECT_EQ(standing.sentence, "All levels are mastered.");
}

}  // namespace
}  // namespace insonate
