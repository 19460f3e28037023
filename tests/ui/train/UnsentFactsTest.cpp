#include "levels/UnsentFacts.h"

#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/teaching/AttemptFactsOf.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>
#include <unit/procedure/ScriptedAttempt.h>

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

namespace insonate::train {
namespace {

const std::string kOne = "11111111-2222-4333-8444-555555555555", kTwo = "66666666-2222-4333-8444-555555555555";

AttemptFacts begunFacts(const std::string& id, std::int64_t begun_us) {
  AttemptFacts made;
  made.id = id, made.person = "tess";
  made.curriculum = "course", made.curriculumVersion = 7, made.level = "first";
  made.procedure = "internal_jugular", made.procedureVersion = 2;
  made.caseName = "<b>\"odd\" \u202E name", made.caseHash = "0123";
  made.begun_us = begun_us;
  return made;
}

/// End of an attempt whose recording is missing.
AttemptFacts brokenOff(AttemptFacts facts) {
  facts.state = AttemptState::Abandoned;
  return facts;
}

class UnsentFacts : public testing::Test {
 protected:
  QString folder() const { return home.filePath("unsent"); }
  void write(const char* name, const QByteArray& bytes) {
    QFile file(QDir(folder()).filePath(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes);
  }
  /// An attempt that reached the vein, recorded in the folder of the recordings, as the window keeps it.
  AttemptFacts recorded(const std::string& id, const char* name) {
    const std::string file = home.filePath(name).toStdString();
    AttemptHeader header;
    header.software = "insonate", header.begun = "2026-01-02T03:04:05Z";
    header.procedure = "internal_jugular", header.procedureVersion = 1;
    header.caseName = "neck", header.caseHash = "c0ffee", header.picture = test::ScriptedAttempt::picture();
    test::ScriptedAttempt attempt;
    attempt.aspirating = true;
    attempt.needleTo(25), attempt.hold(2);
    const auto recorder = AttemptRecorder::start(file, header);
    EXPECT_TRUE(recorder);
    for (const auto& entry : attempt.stream) {
      while ((*recorder)->freeSlots() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      std::visit([&](const auto& what) { (*recorder)->record(what); }, entry);
    }
    EXPECT_TRUE((*recorder)->finish(AttemptStatus::Completed));
    AttemptFacts facts = begunFacts(id, 0);
    EXPECT_TRUE(takeRecording(facts, file));
    EXPECT_EQ(facts.procedureVersion, 1) << "that it began by";
    EXPECT_TRUE(facts.succeeded && facts.id == id && facts.level == "first");
    return facts;
  }
  QTemporaryDir home;
};

TEST_F(UnsentFacts, ComeBackAsTheyWereInTheOrderOfTheirBeginning) {
  // The last microsecond before doubles round to even ones lies 285 years ahead.
  const AttemptFacts late = begunFacts(kOne, 1'800'000'000'000'001), early = begunFacts(kTwo, 1'700'000'000'000'003);
  ASSERT_TRUE(storeUnsent(folder(), late));
  ASSERT_TRUE(storeUnsent(folder(), early));
  EXPECT_EQ(unsentOf(folder(), "tess"), (std::vector{early, late}));
  EXPECT_TRUE(unsentOf(folder(), "other").empty());
  forgetUnsent(folder(), early);
  EXPECT_EQ(unsentOf(folder(), "tess"), std::vector{late});
}

TEST_F(UnsentFacts, AnEndIsWorkedOutFromItsRecording) {
  const AttemptFacts ended = recorded(kOne, "made.attempt");
  ASSERT_TRUE(storeUnsent(folder(), ended));
  EXPECT_EQ(unsentOf(folder(), "tess"), std::vector{ended});
}

/// The file may say what it will: as one of an earlier program, or of someone who would like better points.
TEST_F(UnsentFacts, WhatTheFileSaysOfTheEndIsNotBelieved) {
  const AttemptFacts ended = recorded(kOne, "made.attempt");
  ASSERT_TRUE(storeUnsent(folder(), ended));
  QFile file(QDir(folder()).filePath(QString::fromStdString(kOne) + ".json"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  QJsonObject object = QJsonDocument::fromJson(file.readAll()).object();
  file.close();
  for (const char* field : {"length_us", "points", "metrics", "succeeded", "recordingHash", "handsHash"})
    EXPECT_FALSE(object.contains(QLatin1String(field))) << field;
  object["points"] = 100, object["succeeded"] = true, object["criticalErrors"] = 0, object["length_us"] = 1e9;
  object["metrics"] = QJsonArray{QJsonObject{{"id", "artery_punctures"}, {"version", 1}, {"value", 0}}};
  object["caseName"] = "a harder neck", object["procedure"] = "subclavian", object["state"] = 2;
  write((kOne + ".json").c_str(), QJsonDocument(object).toJson());
  EXPECT_EQ(unsentOf(folder(), "tess"), std::vector{ended});
}

TEST_F(UnsentFacts, AnEndWithoutItsRecordingBrokeOff) {
  const AttemptFacts ended = recorded(kOne, "made.attempt");
  ASSERT_TRUE(storeUnsent(folder(), ended));
  ASSERT_TRUE(QFile::remove(home.filePath("made.attempt")));
  const auto all = unsentOf(folder(), "tess");
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].state, AttemptState::Abandoned);
  EXPECT_FALSE(all[0].succeeded || all[0].points);
  EXPECT_TRUE(all[0].metrics.empty() && all[0].recording.empty());
}

/// The program is killed while it writes: fork() stands for the program.
TEST_F(UnsentFacts, ARecordingWhoseProgramWasKilledIsRecovered) {
  const std::string file = home.filePath("killed.attempt").toStdString();
  AttemptHeader header;
  header.software = "insonate", header.begun = "2026-01-02T03:04:05Z";
  header.procedure = "internal_jugular", header.procedureVersion = 1;
  header.caseName = "neck", header.caseHash = "c0ffee", header.picture = test::ScriptedAttempt::picture();
  header.recordedFor = {kOne, "tess", "course", 7, "first", "nonce"};
  test::ScriptedAttempt attempt;
  attempt.needleTo(25), attempt.hold(2);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const auto recorder = AttemptRecorder::start(file, header);
    if (!recorder) _exit(1);
    for (const auto& entry : attempt.stream) {
      while ((*recorder)->freeSlots() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      std::visit([&](const auto& what) { (*recorder)->record(what); }, entry);
    }
    std::this_thread::sleep_for(std::chrono::seconds(30));
    _exit(1);
  }
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  const auto partial = AttemptRecorder::partialFile(file);
  const auto hasSamples = [&] {
    const auto so_far = std::filesystem::exists(partial) ? AttemptRecording::open(partial) : fail("no file");
    return so_far && so_far->end_us() > 2'000'000;
  };
  while (!hasSamples() && std::chrono::steady_clock::now() < until)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  ASSERT_TRUE(hasSamples());

  recoverInterrupted(folder(), "tess");
  EXPECT_FALSE(std::filesystem::exists(file)) << "its program still writes it";
  EXPECT_TRUE(unsentOf(folder(), "tess").empty());

  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  recoverInterrupted(folder(), "other");
  EXPECT_FALSE(std::filesystem::exists(file)) << "it is another person's";
  recoverInterrupted(folder(), "tess");
  EXPECT_TRUE(std::filesystem::exists(file) && !std::filesystem::exists(partial));
  const auto all = unsentOf(folder(), "tess");
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].id, kOne);
  EXPECT_EQ(all[0].level, "first");
  EXPECT_EQ(all[0].state, AttemptState::Abandoned);
  EXPECT_EQ(all[0].recording, "killed.attempt");
  EXPECT_GT(all[0].length_us, 2'000'000);
  EXPECT_FALSE(all[0].metrics.empty()) << "what was recorded counts";
  recoverInterrupted(folder(), "tess");
  EXPECT_EQ(unsentOf(folder(), "tess"), all) << "a second time changes nothing";
}

TEST_F(UnsentFacts, OfAnAttemptTheLatestCount) {
  AttemptFacts begun = begunFacts(kOne, 1), ended = brokenOff(begun);
  ASSERT_TRUE(storeUnsent(folder(), begun));
  ASSERT_TRUE(storeUnsent(folder(), ended));
  EXPECT_EQ(unsentOf(folder(), "tess"), std::vector{ended});
}

TEST_F(UnsentFacts, AnEndOutlivesItsBeginningThatIsForgottenOrWrittenLate) {
  const AttemptFacts begun = begunFacts(kOne, 1), ended = brokenOff(begun);
  ASSERT_TRUE(storeUnsent(folder(), begun));
  ASSERT_TRUE(storeUnsent(folder(), ended)) << "while the beginning is on its way to the store";
  forgetUnsent(folder(), begun);
  EXPECT_EQ(unsentOf(folder(), "tess"), std::vector{ended});
  ASSERT_TRUE(storeUnsent(folder(), begun));
  EXPECT_EQ(unsentOf(folder(), "tess"), (std::vector{begun, ended})) << "in the order that the store wants";
}

TEST_F(UnsentFacts, WhatCannotBeReadIsLeftOutAndStays) {
  ASSERT_TRUE(storeUnsent(folder(), begunFacts(kOne, 1)));
  write("cut.json", R"({"id": "x", "person": "tess", "sta)");
  write("list.json", "[1, 2]");
  write("state.json", R"({"id": "x", "person": "tess", "state": 99})");
  write("voided.json", R"({"id": "x", "person": "tess", "state": 3})");
  write("nobody.json", R"({"person": "tess", "state": 0})");
  write("large.json", QByteArray(2 << 20, ' '));
  write("noise.json", R"({"id": "x", "person": "tess", "state": 1, "recording": "noise.attempt"})");
  QFile noise(home.filePath("noise.attempt"));
  ASSERT_TRUE(noise.open(QIODevice::WriteOnly));
  noise.write("no recording");
  noise.close();
  EXPECT_EQ(unsentOf(folder(), "tess"), std::vector{begunFacts(kOne, 1)});
  EXPECT_EQ(QDir(folder()).entryList(QDir::Files).size(), 8);
}

TEST_F(UnsentFacts, ARecordingsNameIsNoWayOutOfTheFolder) {
  AttemptFacts facts = begunFacts(kOne, 1);
  for (const char* name : {"../elsewhere.attempt", "/etc/passwd", "", ".."}) {
    facts.recording = name;
    EXPECT_EQ(recordingOf(folder(), facts), QString()) << name;
  }
  facts.recording = "made.attempt";
  EXPECT_EQ(recordingOf(folder(), facts), home.filePath("made.attempt"));
}

TEST_F(UnsentFacts, AFolderThatCannotBeMadeIsSaid) {
  QFile blocking(folder());
  ASSERT_TRUE(blocking.open(QIODevice::WriteOnly));
  const auto kept = storeUnsent(folder(), begunFacts(kOne, 1));
  ASSERT_FALSE(kept);
  EXPECT_THAT(kept.error().message, testing::HasSubstr("check that you may write there"));
}

}  // namespace
}  // namespace insonate::train
