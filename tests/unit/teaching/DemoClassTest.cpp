#include "support/TestData.h"
#include "unit/procedure/ScriptedAttempt.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Statistics.h>
#include <insonate/curriculum/Unlocking.h>
#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/teaching/AttemptFactsOf.h>
#include <insonate/teaching/DemoClass.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <thread>

namespace insonate {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

Curriculum centralLine() {
  auto curriculum = loadCurriculum("central_line");
  EXPECT_TRUE(curriculum) << curriculum.error().message;
  return curriculum ? *curriculum : Curriculum();
}

std::vector<AttemptFacts> attemptsOf(int trainee, const DemoClassPlan& plan) {
  const auto attempts = demoAttempts(centralLine(), trainee, plan);
  EXPECT_TRUE(attempts);
  return *attempts;
}

double pointsOf(const std::vector<AttemptFacts>& attempts, std::size_t from, std::size_t count) {
  std::vector<double> points;
  for (std::size_t i = from; i < from + count; ++i) points.push_back(attempts[i].points.value_or(0));
  return *meanValue(points);
}

TEST(DemoClassTest, TheSameSeedMakesUpTheSame) {
  const DemoClassPlan plan{.attempts = 40};
  EXPECT_EQ(attemptsOf(3, plan), attemptsOf(3, plan));
  EXPECT_NE(attemptsOf(3, plan), attemptsOf(4, plan));
  EXPECT_NE(attemptsOf(3, plan), attemptsOf(3, {.attempts = 40, .seed = 2}));
}

TEST(DemoClassTest, MaxLearnAndLevelsOpen) {
  const Curriculum curriculum = centralLine();
  int better = 0, past = 0;
  for (int trainee = 0; trainee < 20; ++trainee) {
    const auto attempts = attemptsOf(trainee, {.attempts = 60});
    better += pointsOf(attempts, 40, 20) > pointsOf(attempts, 0, 20);
    const auto path = computeProgress(curriculum, attempts, std::numeric_limits<std::int64_t>::max());
    past += path[0].state == LevelState::Mastered || path[0].state == LevelState::Lapsed;
  }
  EXPECT_GE(better, 15) << "of 20";
  EXPECT_GE(past, 10) << "of 20 were through the first level once";
}

TEST(DemoClassTest, OnlyTestsWereOpened) {
  const Curriculum curriculum = centralLine();
  for (int trainee = 0; trainee < 20; ++trainee)
    for (const AttemptFacts& facts : attemptsOf(trainee, {.attempts = 60}))
      EXPECT_EQ(facts.testConditions == TestConditions::Opened,
                curriculum.level(facts.level)->assistance == Assistance::Test)
          << facts.level;
}

TEST(DemoClassTest, ValuesAreOnesThatCouldBe) {
  std::int64_t before_us = 0;
  for (const AttemptFacts& facts : attemptsOf(1, {.attempts = 100})) {
    EXPECT_GT(facts.begun_us, before_us);
    before_us = facts.begun_us;
    EXPECT_FALSE(facts.succeeded && facts.criticalErrors > 0);
    EXPECT_GE(facts.points.value(), 0);
    EXPECT_LE(facts.points.value(), 100);
    for (const MetricFact& metric : facts.metrics) {
      if (!metric.value) continue;
      EXPECT_TRUE(std::isfinite(*metric.value)) << metric.id;
      EXPECT_TRUE(!metric.id.ends_with("_punctures") || *metric.value == std::round(*metric.value)) << metric.id;
      EXPECT_TRUE(!metric.id.ends_with("_percent") || *metric.value >= 0) << metric.id;
    }
  }
}

TEST(DemoClassTest, AStoreIsFilledOnceAndSaysThatItIsMadeUp) {
  const test::TemporaryFolder folder;
  StoreServices services;
  services.passwordCost = PasswordCost::Minimum;
  const auto store = CurriculumStore::open((folder / "made-up.sqlite").string(), services);
  ASSERT_TRUE(store) << store.error().message;
  const DemoClassPlan plan{.trainees = 4, .attempts = 6};
  const auto made = makeDemoClass(*store, centralLine(), plan, "made up");
  EXPECT_FALSE(made) << "of 7 characters";
  const auto again = makeDemoClass(*store, centralLine(), plan, "made up too");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_THAT(makeDemoClass(*store, centralLine(), plan, "made up too").error().message,
              HasSubstr("has people already"));

  const auto teacher = store->signIn(kDemoInstructor, "made up too");
  ASSERT_TRUE(teacher);
  const auto cohorts = CohortStore(*teacher).cohorts();
  ASSERT_EQ(cohorts->size(), 2u);
  std::size_t attempts = 0, learners = 0;
  for (const Cohort& cohort : *cohorts) {
    EXPECT_THAT(cohort.name, StartsWith("Made-up"));
    const auto members = CohortStore(*teacher).members(cohort.id);
    for (const Member& member : *members) {
      EXPECT_THAT(member.person.fullName, StartsWith("Made-up"));
      if (member.teaches) continue;
      ++learners;
      attempts += AttemptStore(*teacher).history(member.person.id)->size();
    }
  }
  EXPECT_EQ(learners, 6u) << "4, and 2 of them once more";
  EXPECT_EQ(attempts, 36u);
}

TEST(DemoClassTest, EachMadeTheirLastAttemptBeforeTheTimeThatIsAskedFor) {
  constexpr std::int64_t kDay_us = 86'400'000'000;
  for (int trainee = 0; trainee < 20; ++trainee) {
    const std::int64_t last_us = attemptsOf(trainee, {.attempts = 7, .until_us = 300 * kDay_us}).back().begun_us;
    EXPECT_LT(last_us, 300 * kDay_us);
    EXPECT_GE(last_us, 290 * kDay_us);
  }
}

class MadeUpRecordings : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(makeDemoClass(store, curriculum, {.trainees = 2, .attempts = 6}, kPassword)); }

  static std::string now() {
    const std::time_t time = std::time(nullptr);
    std::tm parts{};
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", ::gmtime_r(&time, &parts));
    return text;
  }
  std::filesystem::path record(const std::string& procedure) const {
    test::ScriptedAttempt attempt;
    attempt.aspirating = true;
    attempt.needleTo(25), attempt.hold(2);
    AttemptHeader header;
    header.software = "insonate 0.1.0", header.begun = now();
    header.procedure = procedure, header.procedureVersion = 1;
    header.caseName = "neck", header.caseHash = "c0ffee", header.picture = test::ScriptedAttempt::picture();
    const std::filesystem::path file = folder / (procedure + ".attempt");
    const auto recorder = AttemptRecorder::start(file, header);
    for (const auto& entry : attempt.stream) {
      while ((*recorder)->freeSlots() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      std::visit([&](const auto& what) { (*recorder)->record(what); }, entry);
    }
    EXPECT_TRUE((*recorder)->finish(AttemptStatus::Completed));
    return file;
  }

  static constexpr const char* kPassword = "made up too";
  const test::TemporaryFolder folder;
  const Curriculum curriculum = centralLine();
  const CurriculumStore store =
      *CurriculumStore::open((folder / "made-up.sqlite").string(), {.passwordCost = PasswordCost::Minimum});
};

TEST_F(MadeUpRecordings, AreNewestAttemptsWithTheirOwnMetrics) {
  const auto file = record("internal_jugular");
  const auto added = addRecordedAttempts(store, curriculum, {file}, kPassword);
  ASSERT_TRUE(added) << added.error().message;
  const auto trainee = store.signIn("made-up-001", kPassword);
  const auto attempts = AttemptStore(*trainee).page(trainee->person().id, 10);
  ASSERT_EQ(attempts->size(), 7u);
  const AttemptFacts& kept = attempts->front().facts;
  const auto told = factsOfRecording(file);
  EXPECT_EQ(kept.recording, "internal_jugular.attempt");
  EXPECT_EQ(kept.recordingHash, told->recordingHash);
  EXPECT_EQ(kept.metrics, told->metrics);
  EXPECT_EQ(kept.points, told->points);
  EXPECT_EQ(kept.begun_us, told->begun_us);
  EXPECT_EQ(kept.level, curriculum.levels.front().name);
  EXPECT_EQ(kept.testConditions, TestConditions::None) << "the level is no test, which nobody opened";
  const auto other = store.signIn("made-up-002", kPassword);
  EXPECT_EQ(AttemptStore(*other).page(other->person().id, 10)->front().facts.recording, "");
}

TEST_F(MadeUpRecordings, OfAnotherProcedureAreRefused) {
  const auto added = addRecordedAttempts(store, curriculum, {record("subclavian")}, kPassword);
  ASSERT_FALSE(added);
  EXPECT_THAT(added.error().message, HasSubstr("asks for 'internal_jugular'"));
}

}  // namespace
}  // namespace insonate
