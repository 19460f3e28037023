#include "elastic/VesselWall.h"
#include "support/NeckScene.h"

#include <gtest/gtest.h>

namespace insonate::test {
namespace {

/// A vessel that runs along the plane: a band from 10 to 17 mm deep, round across it.
class LongVessel : public AnalyticPlane {
 public:
  static constexpr double kRadius_mm = 3.5;
  bool toldAcross = true;

  explicit LongVessel(std::uint8_t label) {
    blocks = {{-200, 10, 200, 10 + 2 * kRadius_mm, label}};
    below = kMuscle;
  }
  void sampleCurvature(std::span<const PlanePoint> at, float PlaneTissue::*,
                       std::span<OutlineCurvature> bends) const override {
    for (std::size_t n = 0; n < at.size(); ++n) bends[n] = {0, toldAcross ? float(1 / kRadius_mm) : 0};
  }
};

class Tube : public testing::Test {
 protected:
  Deformation ask(const TissuePlane& plane, const BloodPressure& pressure) const {
    Deformation answer;
    const auto model = makeDeformationModel("elastic", table, {.mesh_mm = 0.5}).value();
    model->solve({.plane = &plane, .face = {}, .pressure = pressure, .patientFromProbe = {}}, answer);
    return answer;
  }
  BloodPressure rest() const { return {table.of(kArtery).pressure_kPa, table.of(kVein).pressure_kPa}; }

  const MechanicalTable table = loadMechanicalTable("measured").value();
};

TEST_F(Tube, KnownStiffness) {
  MechanicalTissue vessel;
  vessel.wallYoung_kPa = 300, vessel.wall_mm = 1, vessel.sheathYoung_kPa = 3, vessel.pressure_kPa = 10;
  const double tube = 300 / (1 - 0.49 * 0.49) / 4 + 3 / 1.49;
  const auto along = elastic::tubeStiffness(vessel, {0, 0.25F}),
             askew = elastic::tubeStiffness(vessel, {0.125F, 0.125F});
  EXPECT_NEAR(along.wider_kPa, tube, 1e-3 * tube);
  EXPECT_NEAR(along.narrower_kPa, 30, 1e-3);
  EXPECT_NEAR(askew.wider_kPa, tube / 2, 1e-3 * tube);
  EXPECT_NEAR(askew.narrower_kPa, 15, 1e-3);
  EXPECT_EQ(elastic::tubeStiffness(vessel, {0.25F, 0}).wider_kPa, 0);
  EXPECT_EQ(elastic::tubeStiffness(vessel, {0, 0}).wider_kPa, 0);
  vessel.pressure_kPa = 1000;
  EXPECT_EQ(elastic::tubeStiffness(vessel, {0, 0.25F}).narrower_kPa, along.wider_kPa) << "at most as stiff as wider";
}

/// 40 mmHg of pulse widen a carotid by some per cent, seen along as seen across; a slit would double.
TEST_F(Tube, AnArteryAlongThePlanePulsatesAsMuchAsOneAcrossIt) {
  BloodPressure systole = rest(), diastole = rest();
  systole.artery_kPa += 3.6, diastole.artery_kPa -= 1.8;
  LongVessel along(kArtery);
  AnalyticPlane across;
  across.below = kMuscle;
  across.circles = {{0, 13.5, LongVessel::kRadius_mm, kArtery}};
  // The area of a slit grows as its width, that of a circle as the square of it.
  const auto widened = [&](const TissuePlane& plane, double power) {
    return std::pow(areaRatio(ask(plane, systole), kArtery), power) -
           std::pow(areaRatio(ask(plane, diastole), kArtery), power);
  };
  EXPECT_TRUE(ask(along, systole).converged);
  const double seenAlong = widened(along, 1), seenAcross = widened(across, 0.5);
  RecordProperty("percent_along", std::to_string(100 * seenAlong));
  RecordProperty("percent_across", std::to_string(100 * seenAcross));
  EXPECT_NEAR(seenAcross, 0.07, 0.03);
  EXPECT_NEAR(seenAlong, seenAcross, 0.025);
  along.toldAcross = false;
  EXPECT_GT(widened(along, 1), 0.2) << "what plane strain alone makes of it";
}

TEST_F(Tube, AVeinAlongThePlaneStillCollapsesAndAnArteryDoesNot) {
  LongVessel vein(kVein), artery(kArtery);
  vein.press_mm = artery.press_mm = 6;
  // The lost area lies under the face.
  const auto lost = [&](const TissuePlane& plane) {
    const Deformation answer = ask(plane, rest());
    EXPECT_TRUE(answer.converged);
    const LumenArea& lumen = answer.lumens.at(0);
    return (lumen.rest_mm2 - lumen.area_mm2) / (ProbeFace().width_mm * 2 * LongVessel::kRadius_mm);
  };
  EXPECT_GT(lost(vein), 0.4);
  EXPECT_LT(lost(artery), 0.15);
}

/// Blood in coarse cells keeps its area: in the body, a wall would hold it.
TEST_F(Tube, AVeinBesideTheFaceDoesNotLiftTheSkinWhenItSwells) {
  BloodPressure full = rest();
  full.vein_kPa += 1.6;  // 12 mmHg
  AnalyticPlane beside;
  beside.below = kMuscle;
  beside.circles = {{38, 12, 9, kVein}};
  const Deformation answer = ask(beside, full);
  EXPECT_TRUE(answer.converged);
  EXPECT_TRUE(answer.lumens.empty()) << "not in the image";
  double max_mm = 0;
  for (int i = 0; i < answer.meshColumns; ++i)
    max_mm = std::max(max_mm, double(answer.mesh[i].restZ_mm - answer.mesh[i].z_mm));
  EXPECT_LT(max_mm, 0.3);
  beside.circles = {{0, 12, 9, kVein}};
  EXPECT_GT(areaRatio(ask(beside, full), kVein), 1.05) << "in the image it swells";
}

TEST_F(Tube, TheReferenceAgrees) {
  LongVessel along(kArtery);
  along.press_mm = 3;
  BloodPressure systole = rest();
  systole.artery_kPa += 3.6;
  const DeformationInput input{
      .plane = &along, .face = {}, .pressure = systole, .patientFromProbe = along.patientFromProbe()};
  const auto elastic = makeDeformationModel("elastic", table, {.mesh_mm = 1, .tolerance_mm = 5e-4}).value();
  // The reference halves the mesh that it is asked for.
  const auto reference = makeDeformationModel("reference", table, {.mesh_mm = 2}).value();
  Deformation fast, exact;
  // Again and again, until the face's profile is met where the skin has moved to.
  for (int k = 0; k < 8; ++k) elastic->solve(input, fast);
  reference->solve(input, exact);
  EXPECT_NEAR(areaRatio(fast, kArtery), areaRatio(exact, kArtery), 1e-3);
  EXPECT_NEAR(fast.force_N, exact.force_N, 0.003 * exact.force_N);
}

}  // namespace
}  // namespace insonate::test
