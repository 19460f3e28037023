#include "ToolGrids.h"

#include <insonate/core/Hash.h>
#include <insonate/image/GaussianBlur.h>
#include <insonate/segmentation/VesselTracking.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <numbers>

namespace insonate {
namespace {

using test::difference;
using testing::HasSubstr;

/// A vessel that bends through the grid, a vertebra that touches it on one side along its whole way, and a vessel
/// that is brighter, or less bright, on the other.
class VesselsOnGrids : public test::OnGrids {
 protected:
  static constexpr double kRadius_mm = 4;

  static Vec3 middle(double z) { return {3 * std::sin(z / 14), 2 * std::cos(z / 11) - 1, z}; }
  static double fromMiddle_mm(Vec3 p) {
    double least = 1e9;
    for (double z = p.z - 8; z <= p.z + 8; z += 0.25) least = std::min(least, norm(p - middle(z)));
    return least;
  }
  Selection vessel() const {
    return shape([](Vec3 p) { return std::abs(p.z) <= 14 && fromMiddle_mm(p) <= kRadius_mm; });
  }
  CtVolume ct(double blood_HU, double noise_HU, double other_HU = 90) const {
    CtVolume ct(grid());
    const Selection blood = shape([](Vec3 p) { return fromMiddle_mm(p) <= kRadius_mm; });
    const Selection bone = shape([](Vec3 p) { return p.x > middle(p.z).x + kRadius_mm - 0.5; });
    const Selection other =
        shape([](Vec3 p) { return std::hypot(p.x - middle(p.z).x + 9, p.y - middle(p.z).y) < 5.2; });
    for (std::size_t v = 0; v < ct.voxels.size(); ++v) {
      const double u = unitInterval(hashNode(int(v), 1, 2, 3)) + unitInterval(hashNode(int(v), 5, 6, 7)) - 1;
      const double hu = blood.mask.voxels[v]   ? blood_HU
                        : bone.mask.voxels[v]  ? 650
                        : other.mask.voxels[v] ? blood_HU + other_HU
                                               : 55;
      ct.voxels[v] = static_cast<std::int16_t>(std::lround(hu + noise_HU * 2.45 * u));
    }
    return ct;
  }
  double dice(const Selection& a, const Selection& b) const {
    return 1 - double(difference(a, b)) / double(a.count() + b.count());
  }
};
INSONATE_ON_GRIDS(VesselsOnGrids);

TEST_P(VesselsOnGrids, TwoClicksFindAVesselBetweenBoneAndAnotherVessel) {
  const auto tracked = trackVessel(ct(200, 15), std::array{middle(-14), middle(14)});
  ASSERT_TRUE(tracked) << tracked.error().message;
  const Vec3& s = grid().spacing_mm;
  EXPECT_GT(dice(tracked->lumen, vessel()), std::max({s.x, s.y, s.z}) > 1.5 ? 0.85 : 0.9);
  ASSERT_EQ(tracked->line.size(), tracked->outlines.size());
  for (const Vec3& p : tracked->line) EXPECT_LT(fromMiddle_mm(p), 0.8) << p.x << ' ' << p.y << ' ' << p.z;
  EXPECT_LT(norm(tracked->line.front() - middle(-14)), 2.0);
  EXPECT_LT(norm(tracked->line.back() - middle(14)), 2.0);
}

TEST_P(VesselsOnGrids, ClicksNeedNotBeInTheMiddle) {
  const Vec3 aside{-1.4, 0.9, 0};
  const auto tracked = trackVessel(ct(200, 15), std::array{middle(-14) + aside, middle(0) - aside, middle(14) + aside});
  ASSERT_TRUE(tracked) << tracked.error().message;
  const Vec3& s = grid().spacing_mm;
  EXPECT_GT(dice(tracked->lumen, vessel()), std::max({s.x, s.y, s.z}) > 1.5 ? 0.83 : 0.88);
}

/// A few voxels of noise must not set the level of blood.
TEST_P(VesselsOnGrids, AClickOnDarkNoiseDoesNotSetTheBloodsLevel) {
  const std::array clicks{middle(-14), middle(0), middle(14)};
  CtVolume noisy = ct(200, 40);
  const auto near = [&](Vec3 p) { return std::ranges::any_of(clicks, [&](Vec3 c) { return norm(p - c) < 1.8; }); };
  const Selection dark = shape(near);
  for (std::size_t v = 0; v < noisy.voxels.size(); ++v)
    if (dark.mask.voxels[v]) noisy.voxels[v] = static_cast<std::int16_t>(noisy.voxels[v] - 55);
  const auto tracked = trackVessel(noisy, clicks);
  ASSERT_TRUE(tracked) << tracked.error().message;
  const Vec3& s = grid().spacing_mm;
  EXPECT_GT(dice(tracked->lumen, vessel()), std::max({s.x, s.y, s.z}) > 1.5 ? 0.75 : 0.85);
}

TEST_P(VesselsOnGrids, AVeinBesideAnArteryIsNotTakenForIt) {
  const auto tracked = trackVessel(ct(250, 10, -70), std::array{middle(-14), middle(14)});
  ASSERT_TRUE(tracked) << tracked.error().message;
  const Vec3& s = grid().spacing_mm;
  EXPECT_GT(dice(tracked->lumen, vessel()), std::max({s.x, s.y, s.z}) > 1.5 ? 0.85 : 0.9);
}

TEST_P(VesselsOnGrids, OutlinesHaveTheVesselsArea) {
  const auto tracked = trackVessel(ct(200, 5), std::array{middle(-14), middle(14)});
  ASSERT_TRUE(tracked);
  const VesselOutline& half = tracked->outlines[tracked->outlines.size() / 2];
  EXPECT_NEAR(half.area_mm2(), 50.3, 6) << "pi 4^2";
  EXPECT_NEAR(norm(half.right), 1, 1e-9);
  EXPECT_NEAR(dot(half.right, half.down), 0, 1e-9);
}

TEST_P(VesselsOnGrids, ABranchDoesNotRunOutIntoTheVesselThatItLeaves) {
  const auto inBranch = [](Vec3 p) { return p.z > -8 && p.z < 16 && std::hypot(p.x, p.y) <= 3.5; };
  const Selection branch = shape(inBranch);
  const Selection arch = shape([](Vec3 p) { return std::hypot(p.y, p.z + 18) <= 11; });
  CtVolume ct(grid(), 50);
  for (std::size_t v = 0; v < ct.voxels.size(); ++v)
    if (branch.mask.voxels[v] || arch.mask.voxels[v]) ct.voxels[v] = 350;
  const auto tracked = trackVessel(ct, std::array{Vec3{0, 0, -10}, Vec3{0, 0, 14}});
  ASSERT_TRUE(tracked) << tracked.error().message;
  EXPECT_LT(tracked->outlines.front().area_mm2(), 2 * 38.5) << "pi 3.5^2";
  EXPECT_GT(tracked->outlines.front().area_mm2(), 0.7 * 38.5);
}

TEST_P(VesselsOnGrids, WithoutContrastThereIsNoWallToBeSeen) {
  const auto refused = trackVessel(ct(60, 5), std::array{middle(-14), middle(14)});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("no contrast between vessel and tissue"));
}

/// Along z, the same in all slices, as a scanner shows it: voxels are means, and all is blurred.
CtVolume scanned(Vec3 spacing_mm, const std::function<double(double x, double y)>& sharp_HU, double noise_HU = 0) {
  constexpr int kParts = 8;
  VolumeGeometry g;
  g.spacing_mm = spacing_mm;
  g.size = {61, 61, 41};
  g.origin_mm = -g.center_mm();
  Volume<float> hu(g, 0);
  for (int j = 0; j < g.size[1]; ++j)
    for (int i = 0; i < g.size[0]; ++i) {
      const Vec3 p = g.patientFromIndex() * Vec3{double(i), double(j), 0};
      double mean = 0;
      for (int part = 0; part < kParts * kParts; ++part)
        mean += sharp_HU(p.x + ((part % kParts + 0.5) / kParts - 0.5) * spacing_mm.x,
                         p.y + ((part / kParts + 0.5) / kParts - 0.5) * spacing_mm.y) /
                (kParts * kParts);
      for (int k = 0; k < g.size[2]; ++k) hu.at(i, j, k) = float(mean);
    }
  blurGaussian(hu, 0.4);
  CtVolume ct(g);
  for (std::size_t v = 0; v < ct.voxels.size(); ++v) {
    const double u = unitInterval(hashNode(int(v), 1, 2, 3)) + unitInterval(hashNode(int(v), 5, 6, 7)) - 1;
    ct.voxels[v] = std::int16_t(std::lround(hu.voxels[v] + noise_HU * 2.45 * u));
  }
  return ct;
}

double middleArea_mm2(const TrackedVessel& vessel) {
  return vessel.outlines[vessel.outlines.size() / 2].area_mm2();
}

TEST(VesselTracking, AThinVesselIsNeitherWidenedNorNarrowedByBlur) {
  for (const double radius_mm : {1.5, 2.0, 3.0}) {
    const auto tube = [=](double x, double y) { return std::hypot(x, y) < radius_mm ? 250 : 0; };
    const auto tracked = trackVessel(scanned({0.5, 0.5, 0.75}, tube), std::array{Vec3{0, 0, -12}, Vec3{0, 0, 12}});
    ASSERT_TRUE(tracked) << tracked.error().message;
    EXPECT_NEAR(std::sqrt(middleArea_mm2(*tracked) / std::numbers::pi), radius_mm, 0.15) << radius_mm;
  }
}

TEST(VesselTracking, AFlatVeinIsFoundUpToItsEdges) {
  constexpr double kLong_mm = 9, kShort_mm = 2;
  const double c = std::cos(0.5), s = std::sin(0.5);
  const auto inSlit = [=](double x, double y) {
    return std::hypot((c * x + s * y) / kLong_mm, (c * y - s * x) / kShort_mm) < 1;
  };
  const CtVolume ct = scanned(
      {0.5, 0.5, 0.75}, [=](double x, double y) { return inSlit(x, y) ? 230 : 50; }, 20);
  const Vec3 aside = Vec3{c, s, 0} * 3;
  const auto tracked = trackVessel(ct, std::array{Vec3{0, 0, -14} + aside, Vec3{0, 0, 14} - aside});
  ASSERT_TRUE(tracked) << tracked.error().message;
  std::size_t both = 0, truth = 0, found = 0;
  for (int j = 0; j < ct.geometry.size[1]; ++j)
    for (int i = 0; i < ct.geometry.size[0]; ++i) {
      const Vec3 p = ct.geometry.patientFromIndex() * Vec3{double(i), double(j), 0};
      const bool isIn = inSlit(p.x, p.y), isFound = tracked->lumen.isSelected(i, j, ct.geometry.size[2] / 2);
      both += isIn && isFound, truth += isIn, found += isFound;
    }
  EXPECT_GT(2 * double(both) / double(truth + found), 0.93);
}

/// Thin metal is seen as wide as the blur, over blood as over tissue: it lies in its middle.
TEST(VesselTracking, AStentDoesNotNarrowTheVessel) {
  const auto stented = [](double x, double y) {
    const double r = std::hypot(x, y);
    return r < 8 ? 350 : r < 8.4 ? 3000 : 40;
  };
  const auto tracked = trackVessel(scanned({1, 1, 1}, stented), std::array{Vec3{0, 0, -16}, Vec3{0, 0, 16}});
  ASSERT_TRUE(tracked) << tracked.error().message;
  EXPECT_NEAR(std::sqrt(middleArea_mm2(*tracked) / std::numbers::pi), 8, 0.3);
}

TEST(VesselTracking, RefusesOneClickAndClicksBesideTheCt) {
  const CtVolume ct(test::toolGrids()[0].geometry);
  EXPECT_THAT(trackVessel(ct, std::array{Vec3{}}).error().message, HasSubstr("at least two clicks"));
  EXPECT_THAT(trackVessel(ct, std::array{Vec3{}, Vec3{0, 0, 500}}).error().message, HasSubstr("outside the CT"));
}

/// Slices of 4.25 mm, as in a native CT of the neck.
TEST(VesselTracking, ClicksInNeighboringSlicesAreFarEnoughApart) {
  VolumeGeometry g;
  g.size = {40, 40, 8}, g.spacing_mm = {1, 1, 4.25};
  g.origin_mm = {-20, -20, 0};
  CtVolume ct(g, 50);
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 40; ++i)
        if (std::hypot(i - 20, j - 20) < 6) ct.at(i, j, k) = 300;
  const auto clicksAt = [](std::initializer_list<double> z_mm) {
    std::vector<Vec3> clicks_mm;
    for (const double z : z_mm) clicks_mm.push_back({0, 0, z});
    return clicks_mm;
  };
  const auto tracked = trackVessel(ct, clicksAt({4.25, 8.5, 12.75, 17}));
  ASSERT_TRUE(tracked) << tracked.error().message;
  EXPECT_NEAR(double(tracked->lumen.count()), 3.14159 * 36 * 3, 90);
  EXPECT_FALSE(trackVessel(ct, clicksAt({4.25, 6.5, 17}))) << "both in one slice";
}

TEST(VesselTracking, TwoClicksOnOnePointAreNoVesselButDoNoHarm) {
  CtVolume ct(test::toolGrids()[0].geometry, 50);
  for (std::size_t v = ct.voxels.size() / 2 - 2000; v < ct.voxels.size() / 2 + 2000; ++v) ct.voxels[v] = 300;
  const auto tracked = trackVessel(ct, std::array{Vec3{}, Vec3{}});
  ASSERT_FALSE(tracked);
  EXPECT_THAT(tracked.error().message, HasSubstr("almost at the same point"));
}

}  // namespace
}  // namespace insonate
