#include "support/TestData.h"

#include <insonate/cases/Phantom.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/simulator/ScriptedSession.h>

#include <gmock/gmock.h>

#include <algorithm>

namespace insonate {
namespace {

class CompressibleVein : public testing::TestWithParam<const char*> {};

/// The jugular levels ask that the vein is centered and compressed before the puncture: on each of their necks, 10 mm
/// of the probe over the vein are enough, lying flat and head down.
TEST_P(CompressibleVein, GivesWayUnderTheProbe) {
  const auto patient = makePhantom(GetParam(), 1);
  ASSERT_TRUE(patient) << patient.error().message;
  const auto start = std::ranges::find(patient->manifest.startPoses, "right neck, transverse", &StartPose::name);
  ASSERT_NE(start, patient->manifest.startPoses.end());
  const Transform atStart = *patientFromProbe(start->position_mm, start->axial, start->lateral);
  const Vec3 aside = inverted(atStart) * patient->manifest.targets.front().position_mm;
  for (const double tilt_deg : {0.0, 15.0}) {
    SCOPED_TRACE(tilt_deg);
    Transform over = atStart;
    over.offset = atStart * Vec3{aside.x, aside.y, 0};
    SessionScript script;
    script.procedure = "internal_jugular";
    script.actions = {{ScriptAction::ReportEvent{.kind = AttemptEventKind::Positioned, .tilt_deg = tilt_deg}},
                      {ScriptAction::PlaceProbe{over}},
                      {ScriptAction::Wait{1.5}},
                      {ScriptAction::MoveProbe{over * Vec3{0, 0, 10}, 10}},
                      {ScriptAction::Wait{0.3}}};
    const test::TemporaryFolder folder;
    const auto outcome = runSession(script, *patient, "insonate test", folder / "attempt");
    ASSERT_TRUE(outcome) << outcome.error().message;
    EXPECT_EQ(outcome->metrics[Metric::VeinChecks], 1);
  }
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, CompressibleVein,
                         testing::Values("textbook", "large-sternomastoid", "low-bifurcation", "small-vein",
                                         "head-turned", "deep-in-fat", "collapsed-vein", "vein-over-artery",
                                         "high-bifurcation"),
                         [](const auto& variant) {
                           std::string name;
                           for (const char c : std::string(variant.param))
                             if (c != '-') name += c;
                           return name;
                         });

}  // namespace
}  // namespace insonate
