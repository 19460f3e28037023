#include "WireRig.h"

#include <gmock/gmock.h>

namespace insonate {
namespace {

using test::treeOf;

TEST(VesselTree, DistanceToAStraightTubeIsExact) {
  const VesselTree tree = treeOf({test::straightVein(100, 5)});
  const auto wall = tree.wallAt(kVein, {3, 0, 50});
  EXPECT_NEAR(wall.distance_mm, -2, 1e-9);
  EXPECT_NEAR(wall.outward.x, 1, 1e-9);
  EXPECT_NEAR(std::abs(wall.axis.z), 1, 1e-9);
  EXPECT_NEAR(wall.curvature_1pmm, 1.0 / 3, 1e-9);
  EXPECT_NEAR(tree.locate(kVein, {0, 7, 25}).along_mm, 25, 1e-9);
  EXPECT_NEAR(tree.locate(kVein, {0, 7, 25}).distance_mm, 2, 1e-9);
  EXPECT_GT(tree.wallAt(kArtery, {0, 0, 50}).distance_mm, 1e9) << "veins and arteries are apart";
}

TEST(VesselTree, GridFindsTheNearestWallEverywhere) {
  const CaseManifest& neck = test::neckNamed("textbook");
  const VesselTree tree = VesselTree::make(neck.vessels).value();
  for (int i = 0; i < 400; ++i) {
    const Vec3 p{-70 + 0.35 * i, 10 + 15 * std::sin(i * 0.7), -60 + 100 * std::abs(std::sin(i * 1.3))};
    double least_mm = 1e9;
    for (const auto& vessel : tree.vessels())
      if (vessel.tube.label == kVein) least_mm = std::min(least_mm, distanceToWall_mm(vessel.tube, p));
    EXPECT_NEAR(tree.wallAt(kVein, p).distance_mm, least_mm, 1e-9) << i;
  }
}

TEST(VesselTree, RightJugularVeinLeadsToTheHeartAtPublishedDepth) {
  const CaseManifest& neck = test::neckNamed("textbook");
  const VesselTree tree = VesselTree::make(neck.vessels).value();
  // Right internal jugular vein to the junction with the right atrium: 16 cm (Andrews RT, Bova DA, Venbrux AC. How much
  // guidewire is too much? Crit Care Med 2000;28(1):138-142), left 19 cm or more.
  const auto right = tree.locate(kVein, neck.targets[0].position_mm);
  const auto left = tree.locate(kVein, neck.targets[1].position_mm);
  EXPECT_EQ(tree.vessels()[right.vessel].tube.name, "right internal jugular vein");
  EXPECT_NEAR(right.toHeart_mm, 160, 15);
  EXPECT_GT(left.toHeart_mm, right.toHeart_mm);
  EXPECT_LT(right.towardHeart.z, -0.8);
}

TEST(VesselTree, SubclavianVeinsAndCarotidsLeadToTheHeartToo) {
  const CaseManifest& neck = test::neckNamed("subclavian");
  const VesselTree tree = VesselTree::make(neck.vessels).value();
  for (const NamedVessel& vessel : neck.vessels) {
    const bool isLarge = vessel.name.find("subclavian") != std::string::npos ||
                         vessel.name.find("internal jugular") != std::string::npos ||
                         vessel.name.find("common carotid") != std::string::npos;
    if (!isLarge) continue;
    const Vec3 middle = vessel.course[vessel.course.size() / 2].position_mm;
    const auto at = tree.locate(vessel.label, middle);
    EXPECT_GT(at.toHeart_mm, 50) << vessel.name;
    EXPECT_LT(at.toHeart_mm, 350) << vessel.name;
    EXPECT_EQ(tree.systemAt(middle), vessel.label) << vessel.name;
  }
}

TEST(VesselTree, AtriumIsBeyondTheJunction) {
  const CaseManifest& neck = test::neckNamed("textbook");
  const VesselTree tree = VesselTree::make(neck.vessels).value();
  for (const auto& vessel : tree.vessels())
    if (vessel.tube.name == "right atrium") {
      const auto at = tree.locate(kVein, vessel.tube.course.back().position_mm);
      EXPECT_NEAR(at.toHeart_mm, -45, 1);
      EXPECT_NEAR(at.towardHeart.z, 1, 0.1) << "back up";
    }
}

TEST(VesselTree, FemoralVeinLeadsUpToTheInferiorVenaCava) {
  const auto vein = test::tube("right femoral vein", 100, 5, [](double s) { return Vec3{-60, -40, -500 + s}; });
  const VesselTree tree = treeOf({vein});
  const auto at = tree.locate(kVein, {-60, -40, -450});
  EXPECT_NEAR(at.toHeart_mm, 50 + 100 + 60 + 220, 15);
  EXPECT_GT(at.towardHeart.z, 0.9);
}

TEST(VesselTree, EndsNearAnotherWallAreJoined) {
  const auto trunk = test::straightVein(100, 5);
  const auto branch = test::tube("branch", 60, 3, [](double s) { return Vec3{7 + s, 0, 50}; });
  const auto apart = test::tube("apart", 60, 3, [](double s) { return Vec3{-12 - s, 0, 50}; });
  const VesselTree tree = treeOf({trunk, branch, apart});
  EXPECT_LT(tree.wallAt(kVein, {6, 0, 50}).distance_mm, 0) << "a lumen leads from one to the other";
  EXPECT_GT(tree.wallAt(kVein, {-7, 0, 50}).distance_mm, 0);
}

TEST(VesselTree, CaseWithoutNamesIsRefused) {
  EXPECT_THAT(VesselTree::make({}).error().message, testing::HasSubstr("names no vein"));
}

}  // namespace
}  // namespace insonate
