#include <insonate/simulator/ServoRecord.h>
#include <insonate/tissue/Labels.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace insonate {
namespace {

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
  const auto grid = *TissueGrid::fromLabels(ball);
  const Vec3 outward{std::sqrt(0.75), 0, -0.5}, axis{0, 0, 1};
  NeedleEvent event{.wall = kSkin, .into = kSoftTissue, .tip_mm = outward * 25 + axis * 8, .axis = axis};
  const AttemptEvent told = eventOf(event, {}, grid.get(), {}, {});
  ASSERT_TRUE(told.outward);
  const double angle_deg = std::asin(-dot(*told.outward, axis)) * 180 / std::numbers::pi;
  EXPECT_NEAR(angle_deg, 30, 5) << "voxels of 1 mm; at the tip it would be 12";
  EXPECT_GT(dot(*told.outward, outward), std::cos(6 * std::numbers::pi / 180));
  event.wall = kVein;
  EXPECT_FALSE(eventOf(event, {}, grid.get(), {}, {}).outward) << "of the skin alone";
}

}  // namespace
}  // namespace insonate
