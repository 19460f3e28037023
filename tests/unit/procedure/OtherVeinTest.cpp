#include "unit/procedure/ScriptedAttempt.h"

#include <insonate/procedure/AttemptScore.h>

#include <gmock/gmock.h>

#include <algorithm>

namespace insonate {
namespace {

using test::ScriptedAttempt;
using test::sentences;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

const std::vector<std::string> kNames{"right internal jugular vein", "left internal jugular vein"};

/// The tip goes into a vein from 20 to 30 mm along the needle, and blood is aspirated there for longer than a procedure
/// asks for.
ProcedureRun inVein(std::uint8_t vessel, const std::vector<std::string>& names, const std::string& procedure) {
  ScriptedAttempt attempt;
  attempt.walls = {{kVein, 20, 30, vessel}};
  attempt.aspirating = true;
  attempt.hold(2.1);
  attempt.needleTo(25);
  attempt.hold(3);
  ProcedureRun run(*loadProcedure(procedure), ScriptedAttempt::picture(), names);
  for (const auto& entry : attempt.stream) std::visit([&](const auto& what) { run.add(what); }, entry);
  return run;
}

/// Tells whether a needle in the vein is the success of a procedure; a whole line succeeds with its catheter.
bool endsWithNeedle(const Procedure& procedure) {
  return std::ranges::find(procedure.success, Metric::TipInVein, &MetricLimit::metric) != procedure.success.end();
}

class OtherVein : public testing::TestWithParam<std::string> {};

TEST_P(OtherVein, TheTargetSucceedsAndIsNamed) {
  const ProcedureRun run = inVein(1, kNames, GetParam());
  EXPECT_EQ(run.succeeded(), endsWithNeedle(run.procedure()));
  EXPECT_EQ(run.metrics().needle(), NeedlePlace::Vein);
  EXPECT_EQ(run.metrics().values()[Metric::VeinPunctures], 1);
  EXPECT_EQ(run.metrics().values()[Metric::OtherVeinPunctures], 0);
  EXPECT_THAT(sentences(computeScore(run)), Contains("The right internal jugular vein is reached."));
}

TEST_P(OtherVein, AnyOtherFailsAndIsNamed) {
  for (const std::uint8_t vessel : {std::uint8_t{0}, std::uint8_t{2}, kUnnamedVessel}) {
    SCOPED_TRACE(int{vessel});
    const ProcedureRun run = inVein(vessel, kNames, GetParam());
    EXPECT_FALSE(run.succeeded());
    EXPECT_EQ(run.metrics().needle(), NeedlePlace::WrongPlace) << "red, not green";
    const MetricValues values = run.metrics().values();
    EXPECT_EQ(values[Metric::VeinPunctures], 0);
    EXPECT_EQ(values[Metric::TipInVein], 0);
    EXPECT_EQ(values[Metric::TimeToAccess], std::nullopt);
    EXPECT_EQ(values[Metric::OtherVeinPunctures], 1);
    ASSERT_TRUE(run.nextStep());
    EXPECT_EQ(run.procedure().steps[*run.nextStep()].name, "vein") << "the step is not ticked";
    const AttemptScore score = computeScore(run);
    EXPECT_THAT(sentences(score), Contains(HasSubstr("A vein other than the target was punctured")));
    EXPECT_THAT(sentences(score), Not(Contains(HasSubstr("is reached"))));
    EXPECT_LE(score.points.value_or(0), 50);
  }
}

TEST_P(OtherVein, ACaseWithoutATargetKnowsNoOther) {
  const ProcedureRun run = inVein(0, {}, GetParam());
  EXPECT_EQ(run.succeeded(), endsWithNeedle(run.procedure()));
  EXPECT_THAT(sentences(computeScore(run)), Contains("The vein is reached."));
}

INSTANTIATE_TEST_SUITE_P(Procedures, OtherVein, testing::ValuesIn(procedurePresetNames()));

TEST(VesselIn, IsNamedWhileTheTipIsInIt) {
  ScriptedAttempt attempt;
  attempt.walls = {{kArtery, 5, 8, 3}, {kVein, 20, 30, 1}};
  ProcedureRun run(*loadProcedure("internal_jugular"), ScriptedAttempt::picture(),
                   {"right internal jugular vein", "left internal jugular vein", "right common carotid artery"});
  std::size_t told = 0;
  const auto inAt = [&](double depth_mm) {
    attempt.needleTo(depth_mm);
    for (; told < attempt.stream.size(); ++told)
      std::visit([&](const auto& what) { run.add(what); }, attempt.stream[told]);
    return run.vesselAtTip();
  };
  EXPECT_EQ(inAt(2), "");
  EXPECT_EQ(inAt(6), "right common carotid artery");
  EXPECT_EQ(inAt(12), "");
  EXPECT_EQ(inAt(25), "right internal jugular vein");
  EXPECT_EQ(inAt(33), "") << "behind its posterior wall";
  EXPECT_EQ(inAt(28), "right internal jugular vein") << "drawn back into it";
  EXPECT_EQ(inAt(-5), "");
  const auto& findings = run.findings();
  const auto artery =
      std::ranges::find(findings, std::string("right common carotid artery"), &ProcedureRun::Finding::vessel);
  ASSERT_NE(artery, findings.end());
  EXPECT_THAT(findingText(run.procedure().rules[artery->rule], *artery),
              testing::StartsWith("Right common carotid artery: "));
}

/// On the way to the target a small vein is passed through.
TEST(OtherVeinOnTheWay, IsAnErrorAndTheTargetStillCounts) {
  ScriptedAttempt attempt;
  attempt.walls = {{kVein, 5, 8, kUnnamedVessel}, {kVein, 20, 30, 1}};
  attempt.hasTarget = true;
  attempt.needleTo(25);
  const MetricValues values = attempt.values();
  EXPECT_EQ(values[Metric::OtherVeinPunctures], 1);
  EXPECT_EQ(values[Metric::VeinPunctures], 1);
  EXPECT_EQ(values[Metric::PosteriorWallPunctures], 0) << "that counts the target's posterior wall alone";
  EXPECT_EQ(values[Metric::TipInVein], 1);
}

}  // namespace
}  // namespace insonate
