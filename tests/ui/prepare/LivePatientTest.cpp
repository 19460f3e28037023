#include "model/LivePatient.h"

#include <insonate/tissue/Labels.h>

#include <gtest/gtest.h>
#include <support/SmallCase.h>
#include <ui/support/Patience.h>

#include <QTest>
#include <cmath>

namespace insonate::prepare {
namespace {

using test::kPatience_ms;

/// The same without what lies less than `radius_mm` from a point.
std::shared_ptr<const LabelMap> makeShell(const LabelMap& labels, Vec3 center_mm, double radius_mm) {
  auto cut = std::make_shared<LabelMap>(labels);
  const auto& size = labels.geometry.size;
  const Transform patientFromIndex = labels.geometry.patientFromIndex();
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i)
        if (norm(patientFromIndex * Vec3{double(i), double(j), double(k)} - center_mm) < radius_mm)
          cut->at(i, j, k) = kBackground;
  return cut;
}

TEST(LivePatient, AnUndoneCutOfTheSkinPutsTheProbeBackWhereItStood) {
  const auto patient = std::make_shared<const PatientCase>(test::smallCase());
  LivePatient live(nullptr);
  live.setPatient(patient, {});
  live.setAwake(true);
  live.follow({3, 0, 2});
  ASSERT_TRUE(QTest::qWaitFor([&] { return live.isSettled() && live.shown(); }, kPatience_ms));
  const Transform before = *live.standing();

  live.setLabels(makeShell(patient->labels, before.offset + Vec3{4, 0, 3}, 9), {}, true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return norm(live.standing()->offset - before.offset) > 2; }, kPatience_ms))
      << "it sinks into the hole";
  live.setLabels(std::make_shared<const LabelMap>(patient->labels), {}, true);
  EXPECT_TRUE(QTest::qWaitFor([&] { return norm(live.standing()->offset - before.offset) < 0.1; }, kPatience_ms))
      << "off by " << norm(live.standing()->offset - before.offset) << " mm";
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_GT(dot(live.standing()->linear.column[axis], before.linear.column[axis]), 0.9999) << axis;
}

/// A start pose that is marked here comes up as it was: the probe is not turned or pressed by the clicks before.
TEST(LivePatient, APoseDependsOnThePlaceAndNotOnTheWayToIt) {
  LivePatient live(nullptr);
  live.setPatient(std::make_shared<const PatientCase>(test::smallCase()), {});
  live.setAwake(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return live.isSettled() && live.shown(); }, kPatience_ms));
  live.follow({3, 0, 2});
  const Transform direct = *live.standing();
  const StartPose pressed{"pressed", direct.offset + 6.0 * direct.linear.column[2], direct.linear.column[2],
                          direct.linear.column[0]};
  live.goTo(pressed);
  EXPECT_NEAR(norm(live.standing()->offset - direct.offset), 6, 0.5) << "a saved pose is taken as it is";
  for (const Vec3 place : {Vec3{30, 20, 0}, Vec3{0, 40, 8}, Vec3{-30, 20, -8}, Vec3{0, 20, 30}, Vec3{3, 0, 2}})
    live.follow(place);
  EXPECT_LT(norm(live.standing()->offset - direct.offset), 0.1);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_GT(dot(live.standing()->linear.column[axis], direct.linear.column[axis]), 0.999) << axis;
  EXPECT_GT(live.standing()->linear.column[0].x, 0.9) << "the patient's right on the image's left";
}

TEST(LivePatient, DrawsALabelOfTheAuthorsOwnAsItsTissue) {
  LivePatient live(nullptr);
  live.setAwake(true);
  const auto pictureOf = [&](const PatientCase& patient) {
    live.setPatient(std::make_shared<const PatientCase>(patient), {});
    live.setOwnLabels(patient.manifest.ownLabels);
    EXPECT_TRUE(QTest::qWaitFor([&] { return live.isSettled() && live.shown(); }, kPatience_ms));
    return live.shown()->image.gray;
  };
  const auto bone = pictureOf(test::smallCase());
  EXPECT_NE(pictureOf(test::smallCaseWithOwnLabel(kSoftTissue)), bone);
  EXPECT_EQ(pictureOf(test::smallCaseWithOwnLabel(kBone)), bone);
}

}  // namespace
}  // namespace insonate::prepare
