#include "ToolGrids.h"

#include <insonate/segmentation/Brush.h>
#include <insonate/segmentation/Islands.h>
#include <insonate/segmentation/Margin.h>
#include <insonate/segmentation/RegionGrowing.h>
#include <insonate/segmentation/Smoothing.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>

#include <numbers>

namespace insonate {
namespace {

using test::difference;
using testing::HasSubstr;

constexpr double kBall = 4.0 / 3 * std::numbers::pi;  // volume over radius cubed

class ShapesOnGrids : public test::OnGrids {
 protected:
  /// Two balls of 9 and 5 mm radius, 25 mm apart, and a speck.
  Selection three() const {
    return shape([](Vec3 p) {
      return norm(p - Vec3{-8, 0, 0}) <= 9 || norm(p - Vec3{13, 0, 0}) <= 5 || norm(p - Vec3{0, 15, 10}) <= 1.6;
    });
  }
};
INSONATE_ON_GRIDS(ShapesOnGrids);

TEST_P(ShapesOnGrids, LargestIslandsAreKept) {
  const auto one = largestIslands(three(), 1);
  const auto two = largestIslands(three(), 2);
  ASSERT_TRUE(one && two);
  EXPECT_EQ(difference(*one, ball({-8, 0, 0}, 9)), 0u);
  EXPECT_EQ(two->count(), ball({-8, 0, 0}, 9).count() + ball({13, 0, 0}, 5).count());
  EXPECT_EQ(difference(*largestIslands(three(), 99), three()), 0u);
}

TEST_P(ShapesOnGrids, SmallIslandsAreMeasuredInCubicMillimetres) {
  const auto large = islandsOfMinimumVolume(three(), 100);
  ASSERT_TRUE(large);
  EXPECT_EQ(difference(*large, *largestIslands(three(), 2)), 0u);
  EXPECT_EQ(islandsOfMinimumVolume(three(), 1e6)->count(), 0u);
}

TEST_P(ShapesOnGrids, IslandAtAPointAndNoneBesideThem) {
  const auto small = islandAt(three(), {13, 1, 1});
  ASSERT_TRUE(small);
  EXPECT_EQ(difference(*small, ball({13, 0, 0}, 5)), 0u);
  const auto none = islandAt(three(), {4, -14, 0});
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("No island of the label is at this point"));
  EXPECT_FALSE(islandAt(three(), {1e9, 0, 0}));
  EXPECT_FALSE(islandAt(Selection{}, {0, 0, 0}));
}

TEST_P(ShapesOnGrids, SplitGivesLabelsByFallingSize) {
  const auto split = splitIslands(three(), std::array<std::uint8_t, 2>{kVein, kArtery});
  ASSERT_TRUE(split);
  const auto count = [&](int label) { return std::ranges::count(split->labels.voxels, label); };
  EXPECT_EQ(std::size_t(count(kVein)), ball({-8, 0, 0}, 9).count());
  EXPECT_EQ(std::size_t(count(kArtery)), ball({13, 0, 0}, 5).count());
}

TEST_P(ShapesOnGrids, MedianTakesSpecksAndKeepsABox) {
  const auto box = [](Vec3 p) { return std::abs(p.x) < 10 && std::abs(p.y) < 10 && std::abs(p.z) < 10; };
  const Selection rough = shape([&](Vec3 p) {
    return (box(p) && norm(p - Vec3{3, 3, 3}) > 1.2) || norm(p - Vec3{15, 15, 15}) < 1.2;
  });
  const auto smooth = medianSmoothed(rough, 2.6);
  ASSERT_TRUE(smooth);
  const auto [i, j, k] = nearestVoxel(grid().indexFromPatient() * Vec3{3, 3, 3});
  EXPECT_TRUE(smooth->isSelected(i, j, k)) << "the hole is filled";
  const auto [x, y, z] = nearestVoxel(grid().indexFromPatient() * Vec3{15, 15, 15});
  EXPECT_FALSE(smooth->isSelected(x, y, z)) << "the speck is gone";
  EXPECT_NEAR(volume_mm3(*smooth), volume_mm3(shape(box)), 0.12 * volume_mm3(shape(box)));
}

TEST_P(ShapesOnGrids, OpeningTakesABridgeAndClosingFillsAGap) {
  const auto balls = [](Vec3 p) { return norm(p - Vec3{-9, 0, 0}) <= 7 || norm(p - Vec3{9, 0, 0}) <= 7; };
  const Selection bridged =
      shape([&](Vec3 p) { return balls(p) || (std::hypot(p.y, p.z) < 1.9 && std::abs(p.x) < 9); });
  const auto open = opened(bridged, 3);
  ASSERT_TRUE(open);
  EXPECT_EQ(difference(*largestIslands(*open, 1), *open) > 0, true) << "two pieces";
  for (std::size_t v = 0; v < open->mask.voxels.size(); ++v)
    ASSERT_LE(open->mask.voxels[v], bridged.mask.voxels[v]) << "opening adds nothing";
  const Selection gap = shape([](Vec3 p) { return norm(p) <= 12 && std::abs(p.x) > 1.1; });
  const auto close = closed(gap, 3);
  ASSERT_TRUE(close);
  EXPECT_TRUE(islandAt(*close, {0.1, 0, 0})) << "the gap is filled";
  for (std::size_t v = 0; v < close->mask.voxels.size(); ++v)
    ASSERT_GE(close->mask.voxels[v], gap.mask.voxels[v]) << "closing takes nothing";
}

TEST_P(ShapesOnGrids, GaussianKeepsTheVolumeOfABall) {
  const auto smooth = gaussianSmoothed(ball({0, 0, 0}, 12), 1.5);
  ASSERT_TRUE(smooth);
  // A surface of curvature 1/r moves inward by about sigma^2 / r.
  EXPECT_NEAR(std::cbrt(volume_mm3(*smooth) / kBall), 12 - 1.5 * 1.5 / 12, 0.25);
}

TEST_P(ShapesOnGrids, SmoothingRefusesToLetAShapeVanish) {
  const Selection thin = ball({0, 0, 0}, 2);
  for (const auto& result : {medianSmoothed(thin, 8), opened(thin, 6), gaussianSmoothed(thin, 6)}) {
    ASSERT_FALSE(result);
    EXPECT_THAT(result.error().message, HasSubstr("would vanish"));
  }
  EXPECT_EQ(medianSmoothed(Selection(grid(), boxOf(grid())), 4)->count(), 0u) << "there was none";
}

TEST_P(ShapesOnGrids, JointSmoothingLeavesNoGapBetweenNeighbors) {
  LabelMap labels(grid(), kFat);
  const auto fill = [&](std::uint8_t label, const auto& in) {
    const Selection chosen = shape(in);
    for (std::size_t v = 0; v < labels.voxels.size(); ++v)
      if (chosen.mask.voxels[v]) labels.voxels[v] = label;
  };
  fill(kVein, [](Vec3 p) { return norm(p - Vec3{-6, 0, 0}) < 8; });
  fill(kArtery, [](Vec3 p) { return norm(p - Vec3{6, 0, 0}) < 8 && p.x > 0; });
  fill(kBone, [](Vec3 p) { return p.y > 12; });
  const LabelSet which = LabelSet().set(kVein).set(kArtery).set(kFat);
  const auto smooth = jointlySmoothed(labels, boxOf(grid()), which, 1.5);
  ASSERT_TRUE(smooth) << smooth.error().message;
  for (std::size_t v = 0; v < labels.voxels.size(); ++v) {
    const std::uint8_t label = smooth->labels.voxels[v];
    ASSERT_EQ(label == Proposal::kKeep, labels.voxels[v] == kBone) << "each voxel of the three has one of the three";
  }
  const auto [i, j, k] = nearestVoxel(grid().indexFromPatient() * Vec3{-6, 0, 0});
  EXPECT_EQ(smooth->labels.at(i, j, k), kVein);

  labels.at(2, 2, 2) = kNerve;
  const auto refused = jointlySmoothed(labels, boxOf(grid()), LabelSet(which).set(kNerve), 2);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("The label nerve would vanish"));
}

TEST_P(ShapesOnGrids, GrownIsWhatBallsAroundAllVoxelsReach) {
  const Selection seed = shape([](Vec3 p) { return norm(p - Vec3{2, 1, -1}) <= 2.5; });
  const auto large = grownBy(seed, 5);
  ASSERT_TRUE(large);
  const Transform patientFromIndex = grid().patientFromIndex();
  std::vector<Vec3> points;
  const VoxelBox all = boxOf(grid());
  for (int k = 0; k < all.end[2]; ++k)
    for (int j = 0; j < all.end[1]; ++j)
      for (int i = 0; i < all.end[0]; ++i)
        if (seed.isSelected(i, j, k)) points.push_back(patientFromIndex * Vec3{double(i), double(j), double(k)});
  const Selection expected =
      shape([&](Vec3 p) { return std::ranges::any_of(points, [&](Vec3 q) { return norm(p - q) <= 5 + 1e-9; }); });
  EXPECT_EQ(difference(*large, expected), 0u);
}

TEST_P(ShapesOnGrids, MarginsAndWallsHaveTheirThicknessInMillimetres) {
  const Selection solid = ball({0, 0, 0}, 11);
  const auto radius = [&](const Selection& s) { return std::cbrt(volume_mm3(s) / kBall); };
  EXPECT_NEAR(radius(*grownBy(solid, 4)), 15, 0.9);
  EXPECT_NEAR(radius(*shrunkBy(solid, 4)), 7, 0.9);
  for (const Wall wall : {Wall::kInside, Wall::kMiddle, Wall::kOutside}) {
    const double out = wall == Wall::kInside ? 11 : wall == Wall::kMiddle ? 13 : 15;
    const auto shell = makeShell(solid, 4, wall);
    ASSERT_TRUE(shell);
    const double expected_mm3 = kBall * (std::pow(out, 3) - std::pow(out - 4, 3));
    const Vec3& s = grid().spacing_mm;
    const double tolerance = 0.1 + 0.1 * std::max({s.x, s.y, s.z});
    EXPECT_NEAR(volume_mm3(*shell), expected_mm3, tolerance * expected_mm3) << "walls end on whole voxels";
    EXPECT_FALSE(islandAt(*shell, {0, 0, 0}));
  }
  const auto none = shrunkBy(ball({0, 0, 0}, 3), 9);
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("Nothing of the label would be left"));
}

TEST_P(ShapesOnGrids, ConnectedGrowingStaysInItsPiece) {
  CtVolume ct(grid(), 40);
  const Selection bright = three();
  for (std::size_t v = 0; v < ct.voxels.size(); ++v)
    if (bright.mask.voxels[v]) ct.voxels[v] = 250;
  const auto grown = connected(ct, boxOf(grid()), std::array{Vec3{13, 0, 0}}, {200, 300});
  ASSERT_TRUE(grown) << grown.error().message;
  EXPECT_EQ(difference(*grown, ball({13, 0, 0}, 5)), 0u);
  const auto two =
      connected(ct, boxOf(grid()), std::array{Vec3{13, 0, 0}, Vec3{-8, 0, 0}, Vec3{0, -15, 0}}, {200, 300});
  EXPECT_EQ(difference(*two, *largestIslands(bright, 2)), 0u) << "a seed in the dark does no harm";
  const auto none = connected(ct, boxOf(grid()), std::array{Vec3{0, -15, 0}}, {200, 300});
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("No click in the region is on a voxel from 200 to 300 HU"));
}

TEST_P(ShapesOnGrids, ConfidenceConnectedLearnsTheRange) {
  CtVolume ct(grid(), 40);
  const Selection bright = ball({-8, 0, 0}, 9);
  for (std::size_t v = 0; v < ct.voxels.size(); ++v)
    ct.voxels[v] = static_cast<std::int16_t>((bright.mask.voxels[v] ? 180 : 40) + int(v * 7919 % 61) - 30);
  HuRange used;
  const auto grown = confidenceConnected(ct, boxOf(grid()), std::array{Vec3{-8, 0, 0}}, {}, {}, &used);
  ASSERT_TRUE(grown) << grown.error().message;
  EXPECT_EQ(difference(*grown, bright), 0u);
  EXPECT_NEAR(0.5 * (used.low + used.high), 180, 4);
  const auto beside = confidenceConnected(ct, boxOf(grid()), std::array{Vec3{500, 0, 0}}, {});
  ASSERT_FALSE(beside);
  EXPECT_THAT(beside.error().message, HasSubstr("No click lies in the CT"));
}

TEST(Tools, StopWhenAsked) {
  const VolumeGeometry g = test::toolGrids()[0].geometry;
  Selection all(g, boxOf(g));
  std::ranges::fill(all.mask.voxels, std::uint8_t{1});
  const Progress stop = [](std::string_view, double) { return false; };
  EXPECT_EQ(largestIslands(all, 1, stop).error().message, kCancelled);
  EXPECT_EQ(medianSmoothed(all, 2, stop).error().message, kCancelled);
  EXPECT_EQ(grownBy(all, 2, stop).error().message, kCancelled);
  EXPECT_EQ(connected(CtVolume(g), boxOf(g), std::array{Vec3{}}, {}, stop).error().message, kCancelled);
}

}  // namespace
}  // namespace insonate
