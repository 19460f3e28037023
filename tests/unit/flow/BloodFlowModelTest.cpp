#include <insonate/flow/BloodFlowModel.h>
#include <insonate/tissue/Labels.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace insonate {
namespace {

/// A straight vessel along +z from the chest toward the head, whose radius changes linearly.
NamedVessel vesselOf(const char* name, std::uint8_t label, double radius_mm, double endRadius_mm = 0) {
  NamedVessel vessel{name, label, {}};
  if (endRadius_mm == 0) endRadius_mm = radius_mm;
  for (int i = 0; i <= 20; ++i)
    vessel.course.push_back({{-30, 20, -50.0 + 5 * i}, radius_mm + (endRadius_mm - radius_mm) * i / 20});
  return vessel;
}

/// Volume flow through a cross-section of a tube at a point, positive toward the head, from the velocities themselves.
double flowThrough_mm3ps(const BloodFlow& flow, std::size_t tube, std::size_t point, double areaFactor = 1) {
  const BloodTube& t = flow.tubes[tube];
  const BloodTube::Point& at = t.course[point];
  constexpr int kRings = 400;
  double sum = 0;
  for (int ring = 0; ring < kRings; ++ring) {
    const double r_mm = (ring + 0.5) / kRings * at.radius_mm;
    const Vec3 velocity = bloodVelocity_mmps(flow, t.label, at.position_mm + Vec3{r_mm, 0, 0}, at.radius_mm - r_mm);
    sum += velocity.z * 2 * std::numbers::pi * r_mm * at.radius_mm / kRings;
  }
  return sum * areaFactor;
}

double centerSpeed_mmps(const BloodFlow& flow, std::size_t tube, std::size_t point) {
  return flow.tubes[tube].course[point].scale * flow.tubes[tube].profile_mmps[0];
}

constexpr double kBeat_s = 60.0 / 70;

TEST(BloodFlowModel, VolumeFlowIsTheSameAlongAVesselThatNarrows) {
  const NamedVessel vessels[] = {vesselOf("right common carotid artery", kArtery, 3.6, 2.6),
                                 vesselOf("right internal jugular vein", kVein, 6, 4)};
  BloodFlowModel model(vessels);
  BloodFlow flow;
  for (const double time_s : {0.0, 0.08, 0.3, 0.5, 1.9}) {
    model.at({}, time_s, {}, flow);
    for (std::size_t v = 0; v < 2; ++v) {
      const double expected = model.volumeFlow(v).now_mm3ps * (v == 0 ? 1 : -1);
      for (const std::size_t point : {1, 10, 19})
        EXPECT_NEAR(flowThrough_mm3ps(flow, v, point), expected, 0.01 * std::abs(expected)) << time_s << ' ' << v;
    }
  }
}

TEST(BloodFlowModel, ArteriesFlowFromTheHeartAndVeinsTowardItWhicheverEndIsFirst) {
  NamedVessel artery = vesselOf("left common carotid artery", kArtery, 3), vein = vesselOf("a vein", kVein, 4);
  for (int turn = 0; turn < 2; ++turn) {
    const NamedVessel vessels[] = {artery, vein};
    BloodFlowModel model(vessels);
    BloodFlow flow;
    model.at({}, {}, {}, flow);
    EXPECT_GT(flowThrough_mm3ps(flow, 0, 10), 0);
    EXPECT_LT(flowThrough_mm3ps(flow, 1, 10), 0);
    std::ranges::reverse(artery.course), std::ranges::reverse(vein.course);
  }
}

TEST(BloodFlowModel, ABranchThatDescendsFlowsFromTheVesselInWhichItBegins) {
  NamedVessel branch{"right superior thyroid artery", kArtery, {}};
  for (int i = 0; i <= 10; ++i) branch.course.push_back({{-30.0 + 2 * i, 20, 20.0 - 4 * i}, 1});
  const NamedVessel vessels[] = {vesselOf("right external carotid artery", kArtery, 2.5), branch};
  BloodFlowModel model(vessels);
  BloodFlow flow;
  model.at({}, {}, {}, flow);
  EXPECT_LT(flow.tubes[1].course[5].direction.z, 0);
}

TEST(BloodFlowModel, CarotidVelocitiesAreThoseOfHealthyAdults) {
  const NamedVessel vessels[] = {vesselOf("right common carotid artery", kArtery, 3.1)};
  BloodFlowModel model(vessels);
  BloodFlow flow;
  double peak = 0, least = 1e9, mean = 0;
  constexpr int kSteps = 200;
  for (int i = 0; i < kSteps; ++i) {
    model.at({}, kBeat_s * i / kSteps, {}, flow);
    peak = std::max(peak, centerSpeed_mmps(flow, 0, 10));
    least = std::min(least, centerSpeed_mmps(flow, 0, 10));
    mean += model.volumeFlow(0).now_mm3ps / kSteps;
  }
  EXPECT_GT(peak, 800);
  EXPECT_LT(peak, 1000);
  EXPECT_GT(least, 130);
  EXPECT_LT(least, 270);
  EXPECT_NEAR(mean, 425e3 / 60, 5);
  model.at({}, {}, {}, flow);
  EXPECT_NEAR(model.volumeFlow(0).now_mm3ps, mean, 1);
}

TEST(BloodFlowModel, FlowOfVeinsRisesDuringInspirationAndFallsUnderVentilation) {
  const NamedVessel vessels[] = {vesselOf("right internal jugular vein", kVein, 5.5)};
  BloodFlowModel model(vessels);
  BloodFlow flow;
  Physiology still;
  still.heartRate_perMin = 0;
  const double breath_s = 60 / still.breathing_perMin, inspired_s = 0.4 * breath_s;
  model.at(still, 0, {}, flow);
  const double expired = model.volumeFlow(0).now_mm3ps;
  model.at(still, inspired_s, {}, flow);
  EXPECT_NEAR(model.volumeFlow(0).now_mm3ps / expired, 1.42, 0.02);
  still.breathingSwing_mmHg = -2.5;
  model.at(still, inspired_s, {}, flow);
  EXPECT_NEAR(model.volumeFlow(0).now_mm3ps, expired, 1);
  still.breathingSwing_mmHg = 20;
  model.at(still, 0, {}, flow);
  EXPECT_EQ(model.volumeFlow(0).now_mm3ps, 0);
}

/// Inspiration raises the pressure in the abdomen, against which the blood of the leg flows.
TEST(BloodFlowModel, FlowOfTheLegsVeinsFallsDuringInspiration) {
  const NamedVessel vessels[] = {vesselOf("right common femoral vein", kVein, 5),
                                 vesselOf("right basilic vein", kVein, 2)};
  BloodFlowModel model(vessels);
  BloodFlow flow;
  Physiology still;
  still.heartRate_perMin = 0;
  model.at(still, 0, {}, flow);
  const double leg = model.volumeFlow(0).now_mm3ps, arm = model.volumeFlow(1).now_mm3ps;
  model.at(still, 0.4 * 60 / still.breathing_perMin, {}, flow);
  EXPECT_LT(model.volumeFlow(0).now_mm3ps, 0.8 * leg);
  EXPECT_GT(model.volumeFlow(1).now_mm3ps, 1.2 * arm);
}

TEST(BloodFlowModel, ANarrowedVeinIsFasterAndAClosedOneHasNoFlow) {
  const NamedVessel vessels[] = {vesselOf("right internal jugular vein", kVein, 5)};
  BloodFlowModel model(vessels);
  BloodFlow open, narrow;
  model.at({}, {}, {}, open);
  VesselAreas areas{std::vector<double>(21, 1)};
  areas[0][10] = 0.4;
  model.at({}, {}, areas, narrow);
  const double through = model.volumeFlow(0).now_mm3ps;
  EXPECT_GT(centerSpeed_mmps(narrow, 0, 10), 1.8 * centerSpeed_mmps(open, 0, 10));
  EXPECT_LT(centerSpeed_mmps(narrow, 0, 2), centerSpeed_mmps(open, 0, 2));
  EXPECT_NEAR(-flowThrough_mm3ps(narrow, 0, 10, 0.4), through, 0.01 * through);
  EXPECT_NEAR(-flowThrough_mm3ps(narrow, 0, 2), through, 0.01 * through);
  areas[0][10] = kClosedArea;
  model.at({}, {}, areas, narrow);
  EXPECT_EQ(model.volumeFlow(0).now_mm3ps, 0);
  EXPECT_EQ(centerSpeed_mmps(narrow, 0, 2), 0);
}

TEST(BloodFlowModel, CompressingAVeinExpelsItsBloodTowardTheHeart) {
  const NamedVessel vessels[] = {vesselOf("right internal jugular vein", kVein, 5),
                                 vesselOf("right common carotid artery", kArtery, 3)};
  BloodFlowModel model(vessels);
  BloodFlow steady, augmented;
  const VesselAreas areas{std::vector<double>(21, 0.9), std::vector<double>(21, 0.9)};
  VesselAreas rates{std::vector<double>(21, 0), std::vector<double>(21, 0)};
  model.at({}, {}, areas, rates, steady);
  rates[0][10] = rates[1][10] = -0.8;  // over 5 mm of the vessel
  model.at({}, {}, areas, rates, augmented);
  const double expelled_mm3ps = 0.8 * std::numbers::pi * 25 * 5;
  EXPECT_EQ(flowThrough_mm3ps(augmented, 0, 15), flowThrough_mm3ps(steady, 0, 15)) << "above the compression";
  const double more = flowThrough_mm3ps(augmented, 0, 5, 0.9) - flowThrough_mm3ps(steady, 0, 5, 0.9);
  EXPECT_NEAR(-more, expelled_mm3ps, 0.02 * expelled_mm3ps) << "toward the heart";
  EXPECT_EQ(flowThrough_mm3ps(augmented, 1, 5), flowThrough_mm3ps(steady, 1, 5)) << "arteries are not augmented";
  rates[0][10] = 100;  // refills at once
  model.at({}, {}, areas, rates, augmented);
  EXPECT_EQ(flowThrough_mm3ps(augmented, 0, 5), 0);
}

TEST(BloodFlowModel, ArterialFlowFollowsThePressures) {
  const NamedVessel vessels[] = {vesselOf("right common carotid artery", kArtery, 3.1)};
  BloodFlowModel model(vessels);
  BloodFlow flow;
  Physiology shock;
  shock.systolic_mmHg = 60, shock.diastolic_mmHg = 40;
  model.at(shock, {}, {}, flow);
  EXPECT_NEAR(model.volumeFlow(0).now_mm3ps, 425e3 / 60 / 2, 30);
}

TEST(BloodFlowModel, UnknownVesselsHaveAFlowByTheirRadiusAndOtherLabelsNone) {
  const NamedVessel vessels[] = {vesselOf("some artery", kArtery, 1.2), vesselOf("a nerve", kNerve, 1.2)};
  BloodFlowModel model(vessels);
  BloodFlow flow;
  model.at({}, {}, {}, flow);
  EXPECT_NEAR(model.volumeFlow(0).now_mm3ps, std::numbers::pi / 4 * 300 * 1.728, 1);
  EXPECT_EQ(model.volumeFlow(1).now_mm3ps, 0);
  EXPECT_EQ(bloodVelocity_mmps(flow, kArtery, {-30, 20, 0}, 0), Vec3{});
  EXPECT_EQ(bloodVelocity_mmps(flow, kArtery, {0, 0, 0}, 1), Vec3{});
}

}  // namespace
}  // namespace insonate
