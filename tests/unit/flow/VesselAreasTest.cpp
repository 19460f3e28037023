#include <insonate/flow/VesselAreas.h>
#include <insonate/tissue/Labels.h>

#include <gtest/gtest.h>

namespace insonate {
namespace {

/// The vessel runs along patient z at x = 0, y = 20; a probe at the origin looks along +y.
NamedVessel vein() {
  NamedVessel vessel{"vein", kVein, {}};
  for (int i = -20; i <= 20; ++i) vessel.course.push_back({{0, 20, 3.0 * i}, 5});
  return vessel;
}

Transform pose(bool alongTheVessel) {
  Transform pose;
  const Vec3 beam{0, 1, 0}, lateral = alongTheVessel ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  pose.linear = {{lateral, cross(beam, lateral), beam}};
  return pose;
}

/// Tissue below 10 mm is compressed along the beam to `factor` of its thickness.
PlaneDisplacement compressed(double factor) {
  PlaneDisplacement d{-25, 0, 0.5, 101, 81, {}, {}};
  for (int row = 0; row < d.rows; ++row)
    for (int column = 0; column < d.columns; ++column) {
      const double z_mm = 0.5 * row;
      d.restFromDisplayed.push_back({0, float(z_mm < 10 ? 0 : (z_mm - 10) * (1 / factor - 1))});
    }
  return d;
}

TEST(VesselAreas, AreOneWithoutDisplacement) {
  const NamedVessel vessels[] = {vein()};
  VesselAreas areas;
  computeVesselAreas(vessels, {}, pose(false), areas);
  EXPECT_EQ(areas, VesselAreas{std::vector<double>(41, 1)});
}

TEST(VesselAreas, FollowTheCompressionInShortAndLongAxis) {
  const NamedVessel vessels[] = {vein()};
  for (const double factor : {0.8, 0.4, 0.1}) {
    VesselAreas areas;
    computeVesselAreas(vessels, compressed(factor), pose(false), areas);
    EXPECT_NEAR(areas[0][20], factor, 0.02);
    EXPECT_NEAR(areas[0][25], factor + (1 - factor) / 2, 0.02);
    EXPECT_EQ(areas[0][40], 1);
    computeVesselAreas(vessels, compressed(factor), pose(true), areas);
    for (int i = 15; i <= 25; ++i) EXPECT_NEAR(areas[0][i], factor, 0.03);
  }
}

TEST(VesselAreas, OfAVesselFarFromThePlaneDoNotChange) {
  const NamedVessel vessels[] = {vein()};
  Transform beside = pose(false);
  beside.offset = {60, 0, 0};
  VesselAreas areas;
  computeVesselAreas(vessels, compressed(0.4), beside, areas);
  EXPECT_EQ(areas, VesselAreas{std::vector<double>(41, 1)});
}

}  // namespace
}  // namespace insonate
