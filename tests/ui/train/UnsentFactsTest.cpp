#include "level/UnsentFacts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <limits>

namespace insonate::train {
namespace {

const std::string kOne = "11111111-2222-4333-8444-555555555555", kTwo = "66666666-2222-4333-8444-555555555555";

AttemptFacts facts(const std::string& id, std::int64_t begun_us) {
  AttemptFacts made;
  made.id = id, made.person = "tess";
  made.curriculum = "course", made.curriculumVersion = 7, made.level = "first";
  made.procedure = "internal_jugular", made.procedureVersion = 2;
  made.caseName = "<b>\"odd\" \u202E name", made.caseHash = "0123";
  made.begun_us = begun_us, made.length_us = 61'000'001;
  made.state = AttemptState::Completed, made.succeeded = true, made.criticalErrors = 3;
  made.points = 0.1;
  made.metrics = {{"passes", 1, 2.0}, {"time_to_access_s", 4, std::nullopt}, {"path", 1, 1.0 / 3}};
  made.recording = "2026-11-22 1.attempt", made.recordingHash = "abcd", made.handsHash = "ef01";
  return made;
}

class UnsentFacts : public testing::Test {
 protected:
  QString folder() const { return home.filePath("unsent"); }
  void write(const char* name, const QByteArray& bytes) {
    QFile file(QDir(folder()).filePath(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes);
  }
  QTemporaryDir home;
};

TEST_F(UnsentFacts, ComeBackAsTheyWereInTheOrderOfTheirBeginning) {
  // The last microsecond before doubles round to even ones lies 285 years ahead.
  const AttemptFacts late = facts(kOne, 1'800'000'000'000'001), early = facts(kTwo, 1'700'000'000'000'003);
  ASSERT_TRUE(keepUnsent(folder(), late));
  ASSERT_TRUE(keepUnsent(folder(), early));
  EXPECT_EQ(unsentOf(folder(), "tess"), (std::vector{early, late}));
  EXPECT_TRUE(unsentOf(folder(), "other").empty());
  forgetUnsent(folder(), early);
  EXPECT_EQ(unsentOf(folder(), "tess"), std::vector{late});
}

TEST_F(UnsentFacts, OfAnAttemptTheLatestCount) {
  AttemptFacts begun = facts(kOne, 1);
  begun.state = AttemptState::Open;
  ASSERT_TRUE(keepUnsent(folder(), begun));
  ASSERT_TRUE(keepUnsent(folder(), facts(kOne, 1)));
  EXPECT_EQ(unsentOf(folder(), "tess"), std::vector{facts(kOne, 1)});
}

TEST_F(UnsentFacts, AnEndOutlivesItsBeginningThatIsForgottenOrWrittenLate) {
  AttemptFacts begun = facts(kOne, 1);
  begun.state = AttemptState::Open;
  ASSERT_TRUE(keepUnsent(folder(), begun));
  ASSERT_TRUE(keepUnsent(folder(), facts(kOne, 1))) << "while the beginning is on its way to the store";
  forgetUnsent(folder(), begun);
  EXPECT_EQ(unsentOf(folder(), "tess"), std::vector{facts(kOne, 1)});
  ASSERT_TRUE(keepUnsent(folder(), begun));
  EXPECT_EQ(unsentOf(folder(), "tess"), (std::vector{begun, facts(kOne, 1)})) << "in the order that the store wants";
}

TEST_F(UnsentFacts, WhatCannotBeReadIsLeftOutAndStays) {
  ASSERT_TRUE(keepUnsent(folder(), facts(kOne, 1)));
  write("cut.json", R"({"id": "x", "person": "tess", "sta)");
  write("list.json", "[1, 2]");
  write("state.json", R"({"id": "x", "person": "tess", "state": 99})");
  write("voided.json", R"({"id": "x", "person": "tess", "state": 3})");
  write("nobody.json", R"({"person": "tess", "state": 0})");
  write("large.json", QByteArray(2 << 20, ' '));
  EXPECT_EQ(unsentOf(folder(), "tess"), std::vector{facts(kOne, 1)});
  EXPECT_EQ(QDir(folder()).entryList(QDir::Files).size(), 7);
}

TEST_F(UnsentFacts, AFolderThatCannotBeMadeIsSaid) {
  QFile blocking(folder());
  ASSERT_TRUE(blocking.open(QIODevice::WriteOnly));
  const auto kept = keepUnsent(folder(), facts(kOne, 1));
  ASSERT_FALSE(kept);
  EXPECT_THAT(kept.error().message, testing::HasSubstr("check that you may write there"));
}

}  // namespace
}  // namespace insonate::train
