#include "ScriptedAttempt.h"

#include <insonate/procedure/ProcedureRun.h>

#include <gtest/gtest.h>

namespace insonate {
namespace {

using enum AttemptEventKind;

/// An attempt whose case names the target, another vein and an artery.
class ScanWork : public testing::Test {
 protected:
  ScanWork() { attempt.hasTarget = true; }
  void tell(AttemptEventKind kind, std::uint8_t vessel, double z_mm = 0) {
    attempt.hold(0.1);
    attempt.stream.push_back(
        AttemptEvent{.kind = kind, .wall = kVein, .into = kVein, .vessel = vessel, .tip_mm = {0, 0, z_mm}});
  }
  std::optional<double> value(Metric metric) const { return attempt.values()[metric]; }

  test::ScriptedAttempt attempt;
};

TEST_F(ScanWork, EachVeinCountsOnce) {
  EXPECT_EQ(value(Metric::VeinsSurveyed), 0);
  tell(Compressed, 2);
  tell(Compressed, 2);
  tell(Compressed, kUnnamedVessel);
  EXPECT_EQ(value(Metric::VeinsSurveyed), 1) << "a vein without a name cannot be told from others";
  tell(Compressed, 1);
  EXPECT_EQ(value(Metric::VeinsSurveyed), 2);
  EXPECT_EQ(value(Metric::VeinChecks), 1);
}

TEST_F(ScanWork, TheLengthIsThatBetweenTheFarthestPlacesOfTheTarget) {
  tell(Compressed, 1, 10);
  EXPECT_EQ(value(Metric::VeinLengthChecked), 0);
  tell(Compressed, 1, 25);
  tell(Compressed, 1, -5);
  tell(Compressed, 2, 90);
  EXPECT_EQ(value(Metric::VeinLengthChecked), 30);
}

TEST_F(ScanWork, OnlyTheScanBeforeThePunctureCounts) {
  tell(ColorShown, 1);
  attempt.needleTo(5);
  tell(ColorShown, 1);
  tell(Compressed, 1);
  tell(Compressed, 2);
  EXPECT_EQ(value(Metric::ColorChecks), 1);
  EXPECT_EQ(value(Metric::VeinChecks), 0);
  EXPECT_EQ(value(Metric::VeinsSurveyed), 0);
}

TEST_F(ScanWork, WithoutATargetThereAreNoValues) {
  attempt.hasTarget = false;
  tell(Compressed, 0);
  for (const Metric metric :
       {Metric::VeinChecks, Metric::VeinsSurveyed, Metric::VeinLengthChecked, Metric::ColorChecks})
    EXPECT_EQ(value(metric), std::nullopt);
}

/// The steps before the puncture of a line: veins compared, vein found, color shown.
TEST_F(ScanWork, StepsOfTheScanAreDone) {
  ProcedureRun run(*builtInProcedure("internal_jugular_line"), test::ScriptedAttempt::picture(),
                   {"right internal jugular vein", "left internal jugular vein"});
  const auto stateOf = [&](std::string_view name) {
    for (std::size_t i = 0; i < run.steps().size(); ++i)
      if (run.procedure().steps[i].name == name) return run.steps()[i].state;
    return ProcedureRun::StepState::Open;
  };
  const auto add = [&](AttemptEventKind kind, std::uint8_t vessel) {
    run.add(AttemptEvent{.kind = kind, .wall = kVein, .into = kVein, .vessel = vessel});
  };
  add(Compressed, 2);
  EXPECT_EQ(stateOf("survey"), ProcedureRun::StepState::Open) << "one vein is not a comparison";
  EXPECT_EQ(stateOf("scan"), ProcedureRun::StepState::Open) << "another vein is not the target";
  add(Compressed, 1);
  EXPECT_EQ(stateOf("survey"), ProcedureRun::StepState::Done);
  add(Compressed, 1);
  EXPECT_EQ(stateOf("scan"), ProcedureRun::StepState::Done);
  add(ColorShown, 1);
  EXPECT_EQ(stateOf("color"), ProcedureRun::StepState::Done);
}

}  // namespace
}  // namespace insonate
