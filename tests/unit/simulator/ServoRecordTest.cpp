#include "hand/SkinSurface.h"

#include <insonate/simulator/ServoRecord.h>
#include <insonate/tissue/Labels.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace insonate {
namespace {

double angle_deg(const AttemptEvent& event) {
  return std::asin(-dot(*event.outward, event.axis)) * 180 / std::numbers::pi;
}

/// A ball of 25 mm, pricked at 30 degrees; when its skin gives, the tip is 8 mm on, where the nearest skin faces the
/// other way.
TEST(ServoRecord, SkinFacesAsItDoesWhereTheHoleIs) {
  VolumeGeometry geometry;
  geometry.size = {61, 61, 61};
  geometry.origin_mm = {-30, -30, -30};
  LabelMap ball(geometry);
  for (int k = 0; k < 61; ++k)
    for (int j = 0; j < 61; ++j)
      for (int i = 0; i < 61; ++i)
        if (std::hypot(i - 30, j - 30, k - 30) < 25) ball.at(i, j, k) = kSkin;
  const auto skin = SkinSurface::make(ball);
  ASSERT_TRUE(skin);
  const Vec3 outward{std::sqrt(0.75), 0, -0.5}, axis{0, 0, 1};
  NeedleEvent event{.wall = kSkin, .into = kSoftTissue, .tip_mm = outward * 25 + axis * 8, .axis = axis};
  const AttemptEvent told = makeEvent(event, {}, &*skin, {}, {});
  ASSERT_TRUE(told.outward);
  EXPECT_NEAR(angle_deg(told), 30, 2) << "voxels of 1 mm; at the tip it would be 12";
  EXPECT_GT(dot(*told.outward, outward), std::cos(3 * std::numbers::pi / 180));
  event.wall = kVein;
  EXPECT_FALSE(makeEvent(event, {}, &*skin, {}, {}).outward) << "of the skin alone";
  event.wall = kSkin;
  EXPECT_FALSE(makeEvent(event, {}, nullptr, {}, {}).outward) << "not there yet";
}

/// The tissue at rest may lie elsewhere and turned, as under a probe that presses: the needle's angle is told to the
/// skin of the case all the same.
TEST(ServoRecord, TheAngleIsThatOfTheNeedleToTheSkinOfTheCase) {
  VolumeGeometry geometry;
  geometry.size = {81, 41, 81};
  geometry.origin_mm = {-40, -10, -40};
  LabelMap flat(geometry);
  for (int k = 0; k < 81; ++k)
    for (int j = 10; j < 41; ++j)
      for (int i = 0; i < 81; ++i) flat.at(i, j, k) = kSkin;
  const auto skin = SkinSurface::make(flat);
  ASSERT_TRUE(skin);
  TickContext pressed;
  const double turn = 10 * std::numbers::pi / 180;
  Mat3 turned;
  turned.column[0] = {std::cos(turn), std::sin(turn), 0};
  turned.column[1] = {-std::sin(turn), std::cos(turn), 0};
  pressed.restFromPatient = Transform{turned, {1, -3, 0}};
  for (const double degrees : {30.0, 45.0, 60.0, 90.0}) {
    const double a = degrees * std::numbers::pi / 180;
    const Vec3 axis{std::cos(a), std::sin(a), 0};
    const NeedleEvent event{.wall = kSkin, .into = kSoftTissue, .tip_mm = axis * 7.8, .axis = axis};
    EXPECT_NEAR(angle_deg(makeEvent(event, pressed, &*skin, {}, {})), degrees, 0.05);
  }
}

}  // namespace
}  // namespace insonate
