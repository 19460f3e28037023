#include "unit/procedure/ScriptedAttempt.h"

#include <insonate/procedure/ProcedureRun.h>

#include <gtest/gtest.h>

namespace insonate {
namespace {

using test::ScriptedAttempt;
using StepState = ProcedureRun::StepState;

class ProcedureRunTest : public testing::Test {
 protected:
  /// All of the attempt that the run has not seen.
  void catchUp() {
    for (; seen_ < attempt.stream.size(); ++seen_)
      std::visit([&](const auto& what) { run.add(what); }, attempt.stream[seen_]);
  }
  std::string due() {
    catchUp();
    return run.nextStep() ? run.procedure().steps[*run.nextStep()].name : "";
  }
  std::vector<std::string> findings() {
    catchUp();
    std::vector<std::string> names;
    for (const auto& finding : run.findings()) names.push_back(run.procedure().rules[finding.rule].name);
    return names;
  }
  NeedlePlace needle() {
    catchUp();
    return run.metrics().needle();
  }

  ScriptedAttempt attempt;
  ProcedureRun run{*loadProcedure("internal_jugular"), ScriptedAttempt::picture()};

 private:
  std::size_t seen_ = 0;
};

TEST_F(ProcedureRunTest, FromPositionToWithdrawal) {
  EXPECT_EQ(due(), "position");
  attempt.tell(AttemptEventKind::Positioned);
  EXPECT_EQ(due(), "scan");
  attempt.hold(2.1);
  attempt.tell(AttemptEventKind::Centered, kVein);
  EXPECT_EQ(due(), "scan") << "the vein is not found by resting on the skin";
  attempt.tell(AttemptEventKind::Compressed, kVein);
  EXPECT_EQ(due(), "skin");
  attempt.needleTo(5);
  EXPECT_EQ(due(), "vein");
  attempt.needleTo(25);
  EXPECT_EQ(due(), "confirm");
  attempt.hold(2);
  EXPECT_EQ(due(), "confirm") << "nobody draws";
  attempt.aspirating = true;
  attempt.hold(1.1);
  EXPECT_EQ(due(), "inspect");
  EXPECT_TRUE(run.succeeded());
  attempt.tell(AttemptEventKind::Frozen);
  EXPECT_EQ(due(), "withdraw");
  attempt.needleTo(-5);
  EXPECT_EQ(due(), "");
  EXPECT_TRUE(findings().empty());
  for (const auto& step : run.steps()) EXPECT_EQ(step.state, StepState::Done);
  EXPECT_EQ(run.steps()[2].time_us, 2'600'000) << "2.1 s, and 5 mm at 10 mm/s";
}

/// The step's condition must be the one that tip_in_vein counts.
TEST_F(ProcedureRunTest, BloodIsDrawnOnceTheTipStands) {
  attempt.walls = {{kVein, 20, 45}};
  attempt.aspirating = true;
  attempt.needleTo(40);
  EXPECT_EQ(due(), "confirm") << "2 s of blood, on the way";
  attempt.hold(1.1);
  EXPECT_EQ(due(), "inspect");
  attempt.needleTo(-5);
  EXPECT_EQ(attempt.values()[Metric::TipInVein], 1);
}

TEST_F(ProcedureRunTest, OptionalStepsMayBePassedOver) {
  attempt.needleTo(5);
  EXPECT_EQ(due(), "vein");
  EXPECT_EQ(run.steps()[0].state, StepState::Skipped);
  attempt.tell(AttemptEventKind::Frozen);
  EXPECT_EQ(due(), "vein") << "what is not optional is not passed over";
}

TEST_F(ProcedureRunTest, PulledOutTooEarlyThePassBeginsAnew) {
  attempt.needleTo(12);
  EXPECT_EQ(due(), "vein");
  attempt.needleTo(-5);
  EXPECT_EQ(due(), "skin");
  EXPECT_EQ(run.steps()[2].state, StepState::Open);
  EXPECT_EQ(run.steps()[0].state, StepState::Skipped) << "the patient lies as before";
}

/// Also if blood of the vein was aspirated before: the error says to begin again with a new needle.
TEST_F(ProcedureRunTest, AfterAPunctureOfTheArteryThePassBeginsAnew) {
  attempt.walls = {{kVein, 20, 30}, {kArtery, 35, 40}};
  attempt.aspirating = true;
  attempt.needleTo(25);
  attempt.hold(1.1);
  EXPECT_EQ(due(), "inspect");
  attempt.needleTo(37);
  attempt.tell(AttemptEventKind::Frozen);
  attempt.needleTo(-5);
  EXPECT_EQ(due(), "skin");
  attempt.walls = {{kVein, 20, 30}};
  attempt.needleTo(25);
  attempt.hold(1.1);
  attempt.tell(AttemptEventKind::Frozen);
  attempt.needleTo(-5);
  EXPECT_EQ(due(), "") << "the next pass harmed nothing";
}

TEST_F(ProcedureRunTest, WhatWentWrong) {
  attempt.walls = {{kArtery, 12, 18}, {kVein, 20, 30}};
  attempt.needleTo(35);
  EXPECT_EQ(findings(), (std::vector<std::string>{"artery", "back wall"}));
  EXPECT_EQ(run.findings()[0].time_us, 1'700'000);
  EXPECT_FALSE(run.succeeded());
  attempt.needleTo(-5), attempt.needleTo(5);
  EXPECT_EQ(findings(), (std::vector<std::string>{"artery", "back wall", "used needle"}));
  attempt.needleTo(-5), attempt.needleTo(5);
  EXPECT_EQ(findings().size(), 4u) << "each time anew";
}

TEST_F(ProcedureRunTest, SuccessIsTheTipInTheVein) {
  attempt.needleTo(15);
  catchUp();
  EXPECT_FALSE(run.succeeded());
  attempt.needleTo(25);
  catchUp();
  EXPECT_TRUE(run.succeeded());
  attempt.needleTo(35);
  catchUp();
  EXPECT_FALSE(run.succeeded());
}

/// Figures 22 to 24 of the thesis: green, red, yellow, and as new from the tray.
TEST_F(ProcedureRunTest, WhereTheNeedleIs) {
  EXPECT_EQ(needle(), NeedlePlace::Clean);
  attempt.needleTo(10);
  EXPECT_EQ(needle(), NeedlePlace::UnderSkin);
  attempt.needleTo(25);
  EXPECT_EQ(needle(), NeedlePlace::Vein);
  attempt.needleTo(32);
  EXPECT_EQ(needle(), NeedlePlace::WrongPlace);
  attempt.needleTo(25);
  EXPECT_EQ(needle(), NeedlePlace::Vein);
  attempt.needleTo(10);
  EXPECT_EQ(needle(), NeedlePlace::UnderSkin);
  attempt.needleTo(-5);
  EXPECT_EQ(needle(), NeedlePlace::Used);
  attempt.tell(AttemptEventKind::NeedleReplaced);
  EXPECT_EQ(needle(), NeedlePlace::Clean);
  attempt.walls = {{kBone, 15, 1e9}};
  attempt.needleTo(15);
  EXPECT_EQ(needle(), NeedlePlace::WrongPlace);
}

}  // namespace
}  // namespace insonate
