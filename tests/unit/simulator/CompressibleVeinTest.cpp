#include "support/TestData.h"

#include <insonate/cases/Phantom.h>
#include <insonate/cases/TissueLabels.h>
#include <insonate/image/PlaneDisplacement.h>
#include <insonate/simulator/CompressedTissue.h>
#include <insonate/simulator/Imager.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/simulator/ScriptedSession.h>

#include <gmock/gmock.h>

#include <algorithm>

namespace insonate {
namespace {

struct Compressed {
  const char *variant, *procedure, *pose;
};

class CompressibleVein : public testing::TestWithParam<Compressed> {};

/// The procedures ask that the vein is centered and compressed before the puncture: on each of their cases, 10 mm of
/// the probe over the vein are enough, lying flat and head down. A full axillary vein needs more.
TEST_P(CompressibleVein, GivesWayUnderTheProbe) {
  auto patient = makePhantom(GetParam().variant, 1);
  ASSERT_TRUE(patient) << patient.error().message;
  replaceOwnLabels(*patient);
  const auto start = std::ranges::find(patient->manifest.startPoses, GetParam().pose, &StartPose::name);
  ASSERT_NE(start, patient->manifest.startPoses.end());
  const Transform atStart = *patientFromProbe(start->position_mm, start->axial, start->lateral);
  const Vec3 aside = inverted(atStart) * patient->manifest.targets.front().position_mm;
  for (const double tilt_deg : {0.0, 15.0}) {
    SCOPED_TRACE(tilt_deg);
    const bool isFull = tilt_deg > 0 && GetParam().procedure == std::string_view("axillary");
    Transform over = atStart;
    over.offset = atStart * Vec3{aside.x, aside.y, 0};
    SessionScript script;
    script.procedure = GetParam().procedure;
    script.actions = {{ScriptAction::ReportEvent{.kind = AttemptEventKind::Positioned, .tilt_deg = tilt_deg}},
                      {ScriptAction::PlaceProbe{over}},
                      {ScriptAction::Wait{1.5}},
                      {ScriptAction::MoveProbe{over * Vec3{0, 0, isFull ? 14.0 : 10.0}, 10}},
                      {ScriptAction::Wait{0.3}}};
    const test::TemporaryFolder folder;
    const auto outcome = runSession(script, *patient, "insonate test", folder / "attempt");
    ASSERT_TRUE(outcome) << outcome.error().message;
    EXPECT_EQ(outcome->metrics[Metric::VeinChecks], 1);
  }
}

constexpr Compressed onNeck(const char* variant) {
  return {variant, "internal_jugular", "right neck, transverse"};
}
constexpr Compressed inGroin(const char* variant) {
  return {variant, "femoral", "right groin, transverse"};
}

INSTANTIATE_TEST_SUITE_P(
    BuiltIn, CompressibleVein,
    testing::Values(onNeck("textbook"), onNeck("large-sternomastoid"), onNeck("low-bifurcation"), onNeck("small-vein"),
                    onNeck("head-turned"), onNeck("deep-in-fat"), onNeck("collapsed-vein"), onNeck("vein-over-artery"),
                    onNeck("high-bifurcation"), inGroin("groin"), inGroin("groin-thrombus"), inGroin("groin-overlap"),
                    inGroin("groin-obese"), Compressed{"arm", "basilic", "right upper arm, transverse"},
                    Compressed{"axillary", "axillary", "below the right clavicle, transverse"},
                    Compressed{"subclavian", "subclavian", "below the right clavicle, transverse"}),
    [](const auto& tested) {
      std::string name;
      for (const char c : std::string(tested.param.variant))
        if (c != '-') name += c;
      return name;
    });

/// Height that the structure in the middle of the image has after compression, as a share of its height at rest.
double heightLeft(const PatientCase& patient, Vec3 inside_mm) {
  const StartPose& start = patient.manifest.startPoses.front();
  Transform pose = *patientFromProbe(start.position_mm, start.axial, start.lateral);
  const Vec3 aside = inverted(pose) * inside_mm;
  pose.offset = pose * Vec3{aside.x, aside.y, 0};
  const auto labelAt = [&](double depth_mm) {
    return sampleNearest(patient.labels, patient.labels.geometry.indexFromPatient() * (pose * Vec3{0, 0, depth_mm}));
  };
  double top_mm = aside.z, bottom_mm = aside.z;
  const std::uint8_t label = labelAt(aside.z);
  while (labelAt(top_mm) == label) top_mm -= 0.1;
  while (labelAt(bottom_mm) == label) bottom_mm += 0.1;
  PatientCase tissues = patient;
  replaceOwnLabels(tissues);
  const auto source = makeSceneSource(tissues);
  ImagingSetup setup;
  setup.probe = *loadProbe("linear");
  setup.settings = settingsFor(setup.probe);
  setup.tissues = *loadAcousticTable("neck");
  const auto scene = makeScene(**source, setup, sceneRegion(setup, pose, 20)).value();
  auto tissue = CompressedTissue::make(setup.probe, setup.settings, setup.mechanics).value();
  constexpr double kIn_mm = 9;
  Transform pressed = pose;
  pressed.offset = pose * Vec3{0, 0, kIn_mm};
  tissue.hold(*scene, pressed, bloodPressure({}, setup.mechanics.tissues));
  EXPECT_FALSE(tissue.deformation().displacement.empty());
  // The place of each wall in the image, from the displacement back to rest; the image begins at the pressed face.
  const auto shown_mm = [&](double rest_mm) {
    double shown = 0;
    while (shown < 60 && shown + shiftAt(tissue.deformation().displacement, 0, shown).z < rest_mm - kIn_mm)
      shown += 0.02;
    return shown;
  };
  return (shown_mm(bottom_mm) - shown_mm(top_mm)) / (bottom_mm - top_mm);
}

TEST(ThrombosedVein, DoesNotFlatten) {
  const auto patient = makePhantom("groin-thrombus", 1);
  ASSERT_TRUE(patient) << patient.error().message;
  ASSERT_EQ(patient->manifest.ownLabels.size(), 1U);
  const auto [label, thrombus] = *patient->manifest.ownLabels.begin();
  EXPECT_EQ(thrombus.name, "thrombus");
  Vec3 sum;
  std::size_t count = 0;
  const VolumeGeometry& g = patient->labels.geometry;
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i)
        if (patient->labels.at(i, j, k) == label) {
          sum = sum + g.patientFromIndex() * Vec3{double(i), double(j), double(k)};
          ++count;
        }
  ASSERT_GT(count, 5000U);
  EXPECT_GT(heightLeft(*patient, sum / double(count)), 0.7);
  EXPECT_LT(heightLeft(*patient, patient->manifest.targets.front().position_mm), 0.4) << "above the thrombus";
}

}  // namespace
}  // namespace insonate
