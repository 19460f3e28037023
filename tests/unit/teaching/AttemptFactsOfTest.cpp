#include "support/TestData.h"
#include "unit/procedure/ScriptedAttempt.h"

#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/teaching/AttemptFactsOf.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace insonate {
namespace {

using testing::HasSubstr;

AttemptHeader header() {
  AttemptHeader header;
  header.software = "insonate 0.1.0", header.begun = "2026-01-02T03:04:05Z";
  header.procedure = "internal_jugular", header.procedureVersion = 1;
  header.caseName = "neck", header.caseHash = "c0ffee";
  header.picture = test::ScriptedAttempt::picture();
  return header;
}

std::optional<double> valueOf(const AttemptFacts& facts, std::string_view id) {
  const auto found = std::ranges::find(facts.metrics, id, &MetricFact::id);
  return found == facts.metrics.end() ? std::nullopt : found->value;
}

class AttemptFactsOfTest : public testing::Test {
 protected:
  void record(const test::ScriptedAttempt& attempt, AttemptStatus status, const AttemptHeader& head = header()) const {
    const auto recorder = AttemptRecorder::start(file, head);
    ASSERT_TRUE(recorder) << recorder.error().message;
    for (const auto& entry : attempt.stream) {
      while ((*recorder)->freeSlots() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      std::visit([&](const auto& what) { (*recorder)->record(what); }, entry);
    }
    ASSERT_TRUE((*recorder)->finish(status));
  }

  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "first.attempt";
};

TEST(AttemptFactsOf, AnyTitleOfACaseIsKeptAsFarAsTheStoreTakesIt) {
  AttemptHeader head = header();
  head.caseName = std::string("a\0b", 3);
  EXPECT_EQ(factsFromHeader(head).caseName, "a b");
  head.caseName = std::string(999, 'x') + "\u00fc and more";
  EXPECT_EQ(factsFromHeader(head).caseName, std::string(999, 'x')) << "no half of a letter";
  head.caseName = std::string(1000, 'x');
  EXPECT_EQ(factsFromHeader(head).caseName, head.caseName);
}

/// The tip stood in the vein and drew blood; then the attempt was given up.
TEST_F(AttemptFactsOfTest, AnAbandonedAttemptIsNoSuccess) {
  test::ScriptedAttempt attempt;
  attempt.aspirating = true;
  attempt.needleTo(25), attempt.hold(2);
  record(attempt, AttemptStatus::Abandoned);
  const auto facts = factsOfRecording(file);
  ASSERT_TRUE(facts) << facts.error().message;
  EXPECT_EQ(facts->state, AttemptState::Abandoned);
  EXPECT_EQ(valueOf(*facts, "tip_in_vein"), 1);
  EXPECT_FALSE(facts->succeeded);
  EXPECT_LE(facts->points.value_or(0), 50);
}

TEST_F(AttemptFactsOfTest, ARecordingBecomesFacts) {
  test::ScriptedAttempt attempt;
  attempt.aspirating = true;
  attempt.needleTo(25), attempt.hold(2);
  record(attempt, AttemptStatus::Completed);
  const auto facts = factsOfRecording(file);
  ASSERT_TRUE(facts) << facts.error().message;
  EXPECT_EQ(facts->procedure, "internal_jugular");
  EXPECT_EQ(facts->caseName, "neck");
  EXPECT_EQ(facts->begun_us, 1767323045'000'000) << "20455 days of 86400 s since 1970, and 3 h 4 min 5 s";
  EXPECT_EQ(facts->length_us, 5'000'000) << "30 mm at 10 mm/s, and 2 s";
  EXPECT_EQ(facts->state, AttemptState::Completed);
  EXPECT_TRUE(facts->succeeded);
  EXPECT_EQ(facts->criticalErrors, 0);
  EXPECT_TRUE(facts->points);
  EXPECT_EQ(facts->metrics.size(), std::size_t{kMetricCount});
  EXPECT_EQ(valueOf(*facts, "vein_punctures"), 1);
  EXPECT_FALSE(valueOf(*facts, "nearest_artery_mm")) << "there is none: missing, not 0";
  EXPECT_EQ(facts->recording, "first.attempt");
  EXPECT_EQ(facts->person, "");
  EXPECT_EQ(facts->id, "");
}

TEST_F(AttemptFactsOfTest, HarmIsCounted) {
  test::ScriptedAttempt attempt;
  attempt.walls = {{kArtery, 20, 30}};
  attempt.needleTo(25);
  record(attempt, AttemptStatus::Abandoned);
  const auto facts = factsOfRecording(file);
  ASSERT_TRUE(facts) << facts.error().message;
  EXPECT_EQ(facts->state, AttemptState::Abandoned);
  EXPECT_FALSE(facts->succeeded);
  EXPECT_EQ(facts->criticalErrors, 1);
  EXPECT_EQ(facts->points, 0);
}

TEST_F(AttemptFactsOfTest, WhatWasCutShortIsAbandoned) {
  AttemptFacts facts;
  addEnding(facts, AttemptStatus::CutShort, 1000, {});
  EXPECT_EQ(facts.state, AttemptState::Abandoned);
}

TEST_F(AttemptFactsOfTest, TheHashIsThatOfTheFile) {
  std::ofstream(file, std::ios::binary) << "abc";
  AttemptFacts facts;
  ASSERT_TRUE(addRecording(facts, file));
  EXPECT_EQ(facts.recordingHash, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad") << "FIPS 180-4";
  EXPECT_THAT(addRecording(facts, folder / "none").error().message, HasSubstr("cannot be read"));
}

/// Another date and case in the header make another file of the same hands.
TEST_F(AttemptFactsOfTest, TheHashOfTheHandsStaysWhateverTheHeaderSays) {
  test::ScriptedAttempt attempt;
  attempt.aspirating = true;
  attempt.needleTo(25), attempt.hold(2);
  record(attempt, AttemptStatus::Completed);
  const AttemptFacts first = *factsOfRecording(file);
  std::filesystem::remove(file);
  AttemptHeader rewritten = header();
  rewritten.begun = "2026-02-03T04:05:06Z", rewritten.caseName = "another neck", rewritten.caseHash = "beef";
  record(attempt, AttemptStatus::Completed, rewritten);
  const AttemptFacts second = *factsOfRecording(file);
  EXPECT_EQ(first.handsHash.size(), 64u);
  EXPECT_NE(first.recordingHash, second.recordingHash);
  EXPECT_EQ(first.handsHash, second.handsHash);

  std::filesystem::remove(file);
  attempt.hold(0.5);
  record(attempt, AttemptStatus::Completed);
  EXPECT_NE(factsOfRecording(file)->handsHash, first.handsHash);
}

TEST_F(AttemptFactsOfTest, HandsThatDidNothingHaveNoHash) {
  test::ScriptedAttempt attempt;
  attempt.hold(1);
  record(attempt, AttemptStatus::Abandoned);
  EXPECT_EQ(factsOfRecording(file)->handsHash, "");
}

TEST_F(AttemptFactsOfTest, TheRulesThatScoredItAreNamed) {
  test::ScriptedAttempt attempt;
  attempt.needleTo(25);
  AttemptHeader older = header();
  older.procedureVersion = 0;
  record(attempt, AttemptStatus::Completed, older);
  const auto facts = factsOfRecording(file);
  ASSERT_TRUE(facts) << facts.error().message;
  EXPECT_EQ(facts->procedureVersion, loadProcedure("internal_jugular")->version);
}

TEST_F(AttemptFactsOfTest, AScriptsHandsAreNobodysAttempt) {
  test::ScriptedAttempt attempt;
  attempt.aspirating = true;
  attempt.needleTo(25), attempt.hold(2);
  AttemptHeader scripted = header();
  scripted.isScripted = true;
  record(attempt, AttemptStatus::Completed, scripted);
  EXPECT_THAT(factsOfRecording(file).error().message, HasSubstr("was recorded from a script"));
  const auto demonstration = factsOfRecording(file, Hands::PersonOrScript);
  ASSERT_TRUE(demonstration) << demonstration.error().message;
  EXPECT_TRUE(demonstration->succeeded);
}

TEST_F(AttemptFactsOfTest, RulesThatAreNotHereScoreNothing) {
  test::ScriptedAttempt attempt;
  attempt.needleTo(5);
  AttemptHeader other = header();
  other.procedureVersion = 999;
  record(attempt, AttemptStatus::Completed, other);
  EXPECT_THAT(factsOfRecording(file).error().message, HasSubstr("was made by version 999 of the procedure"));
  std::filesystem::remove(file);
  other.procedure = "brain_surgery";
  record(attempt, AttemptStatus::Completed, other);
  EXPECT_THAT(factsOfRecording(file).error().message, HasSubstr("this program does not know its procedure"));
  EXPECT_THAT(factsOfRecording(folder / "none").error().message, HasSubstr("There is no recording"));
}

/// A recording from another computer must not make this one read a file, whatever is in the file.
TEST_F(AttemptFactsOfTest, AProcedureThatIsAFileIsNotRead) {
  test::ScriptedAttempt attempt;
  attempt.needleTo(5);
  const std::filesystem::path rules = folder / "rules.json";
  std::filesystem::copy_file(INSONATE_SOURCE_DIR "/resources/procedures/internal_jugular.json", rules);
  ASSERT_TRUE(loadProcedure(rules.string()));
  for (const std::string& name :
       {std::string("/etc/passwd"), rules.string(), std::filesystem::relative(rules).string()}) {
    AttemptHeader other = header();
    other.procedure = name;
    record(attempt, AttemptStatus::Completed, other);
    const auto facts = factsOfRecording(file);
    ASSERT_FALSE(facts) << name;
    EXPECT_THAT(facts.error().message, HasSubstr("'" + name + "' is not a built-in procedure"));
    std::filesystem::remove(file);
  }
}

}  // namespace
}  // namespace insonate
