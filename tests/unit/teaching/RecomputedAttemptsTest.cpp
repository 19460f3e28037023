#include "support/TestData.h"
#include "unit/procedure/ScriptedAttempt.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/teaching/AttemptFactsOf.h>
#include <insonate/teaching/RecomputedAttempts.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace insonate {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kId = "1c2f8f6e-6a5e-4b52-9c3e-6a1c55d1e0aa";

/// A recording of an attempt that reached the vein, and what is stored of it.
class RecomputedAttemptsTest : public testing::Test {
 protected:
  void SetUp() override { record(AttemptHeader{}); }

  void record(AttemptHeader header) {
    std::filesystem::remove(file);
    header.software = "insonate 0.1.0", header.begun = "2026-01-02T03:04:05Z";
    header.procedure = "internal_jugular", header.procedureVersion = loadProcedure("internal_jugular")->version;
    header.caseName = "neck", header.caseHash = "c0ffee", header.picture = test::ScriptedAttempt::picture();
    test::ScriptedAttempt attempt;
    attempt.aspirating = true;
    attempt.needleTo(25), attempt.hold(2);
    const auto recorder = AttemptRecorder::start(file, header);
    ASSERT_TRUE(recorder) << recorder.error().message;
    for (const auto& entry : attempt.stream) {
      while ((*recorder)->freeSlots() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      std::visit([&](const auto& what) { (*recorder)->record(what); }, entry);
    }
    ASSERT_TRUE((*recorder)->finish(AttemptStatus::Completed));
    const auto made = factsOfRecording(file, Hands::PersonOrScript);
    ASSERT_TRUE(made) << made.error().message;
    facts = *made;
    facts.id = kId, facts.person = "tess";
  }

  RecomputedAttempts compared() const {
    RecomputedAttempts found;
    const auto done = compareWithRecording(facts, file, found);
    EXPECT_TRUE(done) << done.error().message;
    return found;
  }
  /// "field: stored, expected" of each difference.
  std::vector<std::string> differences() const {
    std::vector<std::string> all;
    for (const StoreDifference& one : compared().differences) {
      EXPECT_EQ(one.attempt, kId);
      EXPECT_EQ(one.person, "tess");
      all.push_back(one.field + ": " + one.stored + ", " + one.expected);
    }
    return all;
  }
  MetricFact& metric(std::string_view id) { return *std::ranges::find(facts.metrics, id, &MetricFact::id); }

  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "first.attempt";
  AttemptFacts facts;
};

TEST_F(RecomputedAttemptsTest, WhatTheRecordingGaveAgrees) {
  const RecomputedAttempts found = compared();
  EXPECT_EQ(found.compared, 1);
  EXPECT_THAT(found.differences, IsEmpty());
  EXPECT_THAT(found.notCompared, IsEmpty());
  facts.state = AttemptState::Voided;
  EXPECT_THAT(differences(), IsEmpty()) << "its end stays what it was";
  metric("needle_path_mm").value = *metric("needle_path_mm").value * (1 + 1e-13);
  EXPECT_THAT(differences(), IsEmpty()) << "another computer's last digit";
}

TEST_F(RecomputedAttemptsTest, EachEditedFieldIsNamedWithBothValues) {
  facts.points = 12.5;
  facts.succeeded = false;
  facts.criticalErrors = 2;
  facts.length_us = 60'000'000;
  facts.state = AttemptState::Abandoned;
  facts.caseName = "a harder neck";
  metric("vein_punctures").value = 3;
  metric("nearest_artery_mm").value = 9.5;
  EXPECT_THAT(differences(),
              ElementsAre("case: a harder neck, neck", "state: abandoned, completed", "length, us: 60000000, 5000000",
                          "succeeded: no, yes", "critical errors: 2, 0", "points: 12.5, 100",
                          "metric vein_punctures: 3, 1", "metric nearest_artery_mm: 9.5, n/a"));
}

TEST_F(RecomputedAttemptsTest, AnotherFileAndAScriptsHandsAreDifferences) {
  facts.recordingHash = std::string(64, '0');
  EXPECT_THAT(differences(), ElementsAre(HasSubstr("recording hash: 0000")));
  AttemptHeader scripted;
  scripted.isScripted = true;
  record(scripted);
  EXPECT_THAT(differences(), ElementsAre("hands: a person's, a script's"));
}

/// The numbers follow from the recorded events, but the events not from the motion.
TEST_F(RecomputedAttemptsTest, EventsThatDoNotFollowFromTheMotionAreDifferences) {
  RecomputedAttempts found;
  const CompareEvents one = [](const AttemptRecording& recording, const Progress&) {
    EXPECT_EQ(recording.header().caseHash, "c0ffee");
    return std::vector<EventDifference>{{12'300'000, "needle event at 12.3 s", "none", "entered: artery"}};
  };
  ASSERT_TRUE(compareWithRecording(facts, file, found, one));
  ASSERT_EQ(found.differences.size(), 1U);
  EXPECT_EQ(found.differences[0].field, "needle event at 12.3 s");
  EXPECT_EQ(found.differences[0].stored, "none");
  EXPECT_EQ(found.differences[0].expected, "entered: artery");
  EXPECT_EQ(found.differences[0].attempt, kId);
}

TEST_F(RecomputedAttemptsTest, WithoutTheCaseEventsAreNotComparedAndThatIsSaid) {
  RecomputedAttempts found;
  const CompareEvents none = [](const AttemptRecording&, const Progress&) -> Result<std::vector<EventDifference>> {
    return fail("The case is not here.");
  };
  ASSERT_TRUE(compareWithRecording(facts, file, found, none));
  EXPECT_THAT(found.differences, IsEmpty());
  EXPECT_EQ(found.eventsNotCompared.at("The case is not here."), 1);
  const CompareEvents cancelled = [](const AttemptRecording&, const Progress&) -> Result<std::vector<EventDifference>> {
    return fail(std::string(kCancelled));
  };
  EXPECT_EQ(compareWithRecording(facts, file, found, cancelled).error().message, kCancelled);
}

/// Definitions change; what was measured by an earlier one is not compared, and that is said.
TEST_F(RecomputedAttemptsTest, EarlierDefinitionsAreNamedAndNotCompared) {
  metric("tip_in_vein").version = 1;
  metric("tip_in_vein").value = 0;
  facts.metrics.push_back({"a_metric_of_old", 1, 5.0});
  std::erase_if(facts.metrics, [](const MetricFact& one) { return one.id == "vein_checks"; });
  const RecomputedAttempts found = compared();
  EXPECT_THAT(found.differences, IsEmpty());
  ASSERT_EQ(found.notCompared.size(), 3U);
  EXPECT_TRUE(found.notCompared.contains("metric tip_in_vein: measured by definition 1, 3 here"));
  EXPECT_TRUE(found.notCompared.contains("metric a_metric_of_old: not defined here"));
}

TEST_F(RecomputedAttemptsTest, AVersionThatCannotBeIsNoWayAroundTheComparison) {
  metric("tip_in_vein").version = 99;
  facts.procedureVersion += 1;
  facts.points = 100;
  EXPECT_THAT(differences(), ElementsAre(HasSubstr("procedure version"), "version of metric tip_in_vein: 99, 3"));
  facts.procedureVersion -= 2;
  EXPECT_THAT(differences(), ElementsAre(HasSubstr("procedure version"), "version of metric tip_in_vein: 99, 3"))
      << "the recording was begun by a later one";
}

/// The whole way: what a store keeps, and what is left without a recording.
TEST_F(RecomputedAttemptsTest, AStoresAttemptsAreRecomputedAndTheRestIsNamed) {
  const auto store = CurriculumStore::open((folder / "people.db").string(), {.passwordCost = PasswordCost::Minimum});
  ASSERT_TRUE(store) << store.error().message;
  const auto admin = store->createFirstAdministrator({"admin", "Ada Min", "", Role::Administrator}, "a long sentence");
  ASSERT_TRUE(admin) << admin.error().message;
  const AttemptStore attempts(*admin);
  ASSERT_TRUE(attempts.add(facts, file));
  AttemptFacts bare = facts;
  bare.id.clear(), bare.recording.clear(), bare.recordingHash.clear(), bare.handsHash.clear();
  ASSERT_TRUE(attempts.add(bare));
  ASSERT_TRUE(attempts.begin(factsFromHeader(AttemptHeader{})));

  const auto found = recomputeAttempts(*admin, {}, {});
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_EQ(found->compared, 1);
  EXPECT_THAT(found->differences, IsEmpty());
  ASSERT_EQ(found->left.size(), 1U) << "the open one is no end";
  EXPECT_EQ(found->left[0].why, "it has no recording");
  ASSERT_EQ(found->implausible.size(), 2U) << "5 s long";
  EXPECT_THAT(found->implausible[1].words, testing::Contains("all values of an earlier attempt"));

  const auto cancelled = recomputeAttempts(*admin, {}, [](std::string_view, double) { return false; });
  EXPECT_EQ(cancelled.error().message, kCancelled);
  std::filesystem::remove(store->recordings() / (std::string(kId) + ".attempt"));
  EXPECT_THAT(recomputeAttempts(*admin, {}, {})->left[0].why, HasSubstr("is not kept by this store"));
}

}  // namespace
}  // namespace insonate
