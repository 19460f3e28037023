#include "AttemptMaker.h"

#include <insonate/curriculum/AttemptTable.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace insonate {
namespace {

std::string fieldOf(const AttemptFacts& attempt, const Curriculum* curriculum, const std::string& column) {
  const auto columns = attemptColumns(), row = attemptRow(attempt, curriculum);
  EXPECT_EQ(row.size(), columns.size());
  const auto at = std::ranges::find(columns, column) - columns.begin();
  return at < std::ssize(row) ? row[static_cast<std::size_t>(at)] : "no such column";
}

TEST(AttemptTable, SaysWhatSucceededPassedAndWasVoided) {
  Curriculum course = test::courseOf({test::levelNamed("a", 1)});
  course.levels[0].assistance = Assistance::Test;
  course.levels[0].pass.minPoints = 60;
  AttemptFacts attempt = test::passedAttempt("a");
  attempt.testConditions = TestConditions::Opened;
  attempt.points = 50;
  EXPECT_EQ(fieldOf(attempt, &course, "id"), attempt.id);
  EXPECT_EQ(fieldOf(attempt, &course, "begun (UTC)"), "2026-11-22T12:00:00.000Z");
  EXPECT_EQ(fieldOf(attempt, &course, "assistance"), "test");
  EXPECT_EQ(fieldOf(attempt, &course, "state"), "completed");
  EXPECT_EQ(fieldOf(attempt, &course, "succeeded"), "yes");
  EXPECT_EQ(fieldOf(attempt, &course, "passed"), "no") << "which asks for more than success";
  EXPECT_EQ(fieldOf(attempt, &course, "voided"), "no");
  EXPECT_EQ(fieldOf(attempt, &course, "duration, s"), "60");
  attempt.points = 60;
  EXPECT_EQ(fieldOf(attempt, &course, "passed"), "yes");
  EXPECT_EQ(fieldOf(attempt, &course, "proof"), "proven");
  attempt.proof = AttemptProof::Unproven;
  EXPECT_EQ(fieldOf(attempt, &course, "proof"), "not proven");
  EXPECT_EQ(fieldOf(attempt, &course, "passed"), "") << "it does not count";
  attempt.proof = AttemptProof::Proven;
  attempt.state = AttemptState::Voided;
  EXPECT_EQ(fieldOf(attempt, &course, "voided"), "yes");
  EXPECT_EQ(fieldOf(attempt, &course, "state"), "voided");
  EXPECT_EQ(fieldOf(attempt, &course, "passed"), "") << "nothing is passed any more";
}

TEST(AttemptTable, SaysWhetherATestWasOpen) {
  Curriculum course = test::courseOf({test::levelNamed("a", 1)});
  AttemptFacts attempt = test::passedAttempt("a");
  attempt.testConditions = TestConditions::Earlier;
  EXPECT_EQ(fieldOf(attempt, &course, "sitting"), "") << "the level is no test";
  course.levels[0].assistance = Assistance::Test;
  for (const auto& [testConditions, word, passed] :
       {std::tuple{TestConditions::Earlier, "earlier", "yes"}, std::tuple{TestConditions::Opened, "opened", "yes"},
        std::tuple{TestConditions::SelfAdministered, "self-administered", "yes"},
        std::tuple{TestConditions::Practice, "practice", ""}, std::tuple{TestConditions::None, "practice", ""},
        std::tuple{TestConditions::Undecided, "undecided", ""}}) {
    attempt.testConditions = testConditions;
    EXPECT_EQ(fieldOf(attempt, &course, "sitting"), word);
    EXPECT_EQ(fieldOf(attempt, &course, "passed"), passed) << word;
  }
}

TEST(AttemptTable, ARecordingThatBrokeOffIsAbandonedAndFailed) {
  const Curriculum course = test::courseOf({test::levelNamed("a", 1)});
  AttemptFacts broken = test::passedAttempt("a");
  EXPECT_EQ(fieldOf(broken, &course, "broke off"), "no");
  broken.state = AttemptState::Abandoned, broken.metrics.clear();
  EXPECT_EQ(fieldOf(broken, &course, "state"), "abandoned");
  EXPECT_EQ(fieldOf(broken, &course, "points"), "") << "as in the window";
  EXPECT_EQ(fieldOf(broken, &course, "broke off"), "yes");
  EXPECT_EQ(fieldOf(broken, &course, "succeeded"), "no");
  EXPECT_EQ(fieldOf(broken, &course, "passed"), "no");
  broken.metrics = {{"passes", 1, 1.0}};
  EXPECT_EQ(fieldOf(broken, &course, "broke off"), "no") << "the trainee gave it up";
}

TEST(AttemptTable, FreePracticePassesNothing) {
  const Curriculum course = test::courseOf({test::levelNamed("a", 1)});
  AttemptFacts practice = test::passedAttempt("");
  practice.curriculum = "", practice.curriculumVersion = 0;
  for (const char* column : {"curriculum", "version", "level", "assistance", "passed"})
    EXPECT_EQ(fieldOf(practice, &course, column), "") << column;
  EXPECT_EQ(fieldOf(practice, &course, "succeeded"), "yes");
  EXPECT_EQ(fieldOf(test::passedAttempt("a"), nullptr, "passed"), "") << "without a curriculum";
}

TEST(AttemptTable, NumbersHaveTheDigitsThatPeopleRead) {
  EXPECT_EQ(numberOf(0.254), "0.25");
  EXPECT_EQ(numberOf(-12.54), "-12.5");
  EXPECT_EQ(numberOf(130.6), "131");
  EXPECT_EQ(numberOf(7), "7");
}

}  // namespace
}  // namespace insonate
