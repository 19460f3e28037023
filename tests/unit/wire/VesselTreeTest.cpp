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

/// A label map of 0.5 mm with an elliptic vein along z, whose center lies 1 mm beside the course.
LabelMap flatVein(double a_mm, double b_mm) {
  VolumeGeometry grid;
  grid.size = {80, 60, 60}, grid.spacing_mm = {0.5, 0.5, 1}, grid.origin_mm = {-20, -15, 0};
  LabelMap labels(grid, kSoftTissue);
  for (int k = 0; k < 60; ++k)
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 80; ++i) {
        const double x = (-20 + 0.5 * i - 1) / a_mm, y = (-15 + 0.5 * j) / b_mm;
        if (x * x + y * y < 1) labels.at(i, j, k) = kVein;
      }
  return labels;
}

TEST(VesselTree, LumenHasTheShapeOfTheLabelMap) {
  const LabelMap labels = flatVein(8, 3);
  const std::vector<NamedVessel> vessels{test::straightVein(60, 5)};
  const VesselTree tree = VesselTree::make(vessels, &labels).value();
  EXPECT_NEAR(tree.wallAt(kVein, {1, 3, 30}).distance_mm, 0, 0.2);
  EXPECT_NEAR(tree.wallAt(kVein, {1, -3, 30}).distance_mm, 0, 0.2);
  EXPECT_NEAR(tree.wallAt(kVein, {9, 0, 30}).distance_mm, 0, 0.3);
  EXPECT_NEAR(tree.wallAt(kVein, {-7, 0, 30}).distance_mm, 0, 0.3);
  EXPECT_NEAR(tree.wallAt(kVein, {1, 4, 30}).distance_mm, 1, 0.25);
  EXPECT_NEAR(tree.vessels()[0].tube.course[10].position_mm.x, 1, 0.1);
}

TEST(VesselTree, OutwardIsTheGradientOfTheDistanceInAnEllipseToo) {
  LabelMap labels = flatVein(8, 3);
  for (int k = 0; k < 60; ++k)  // narrows along z
    for (int j = 0; j < 60; ++j)
      for (int i = 0; i < 80; ++i)
        if (std::abs(-20 + 0.5 * i - 1) > 8 - 0.06 * k) labels.at(i, j, k) = kSoftTissue;
  const std::vector<NamedVessel> vessels{test::straightVein(60, 5)};
  const VesselTree tree = VesselTree::make(vessels, &labels).value();
  constexpr double kStep = 1e-6;
  for (const Vec3 p : {Vec3{1, 2.8, 31}, Vec3{6, 2, 33}, Vec3{-5, -2.5, 21}, Vec3{9, 0.4, 40.5}}) {
    const Vec3 outward = tree.wallAt(kVein, p).outward;
    for (int a = 0; a < 3; ++a) {
      Vec3 plus = p, minus = p;
      plus[a] += kStep, minus[a] -= kStep;
      const double slope = (tree.wallAt(kVein, plus).distance_mm - tree.wallAt(kVein, minus).distance_mm) / (2 * kStep);
      EXPECT_NEAR(outward[a], slope, 1e-5) << p.x << ' ' << a;
    }
    EXPECT_NEAR(norm(outward), 1, 0.15) << p.x;
  }
}

TEST(VesselTree, StubOfTheVenaCavaIsNoWayToTheHeart) {
  // As in a label map that ends at the confluence: a thin piece across.
  const auto jugular = test::tube("right internal jugular vein", 100, 7, [](double s) {
    return Vec3{-20, 15, -110 + s};
  });
  const NamedVessel stub{"superior vena cava", kVein, {{{-10, 22, -125}, 0.7}, {{-20, 7, -126}, 0.7}}};
  const VesselTree tree = treeOf({jugular, stub});
  const auto at = tree.locate(kVein, {-20, 15, -60});
  EXPECT_NEAR(at.toHeart_mm, 50 + 25 + 70, 10);
  EXPECT_LT(tree.wallAt(kVein, {-20, 15, -150}).distance_mm, -5) << "a wide vena cava below";
}

TEST(VesselTree, CoursesWithoutLengthAreLeftOut) {
  const NamedVessel point{"point", kVein, {{{30, 0, 0}, 3}}}, twice{"twice", kVein, {{{30, 0, 0}, 3}, {{30, 0, 0}, 3}}};
  const NamedVessel thin{"thin", kVein, {{{60, 0, 0}, 0}, {{60, 0, 50}, 0}}};
  const VesselTree tree = treeOf({test::straightVein(60, 5), point, twice, thin});
  for (const auto& vessel : tree.vessels()) EXPECT_GT(vessel.tube.course.size(), 1U) << vessel.tube.name;
  EXPECT_NEAR(tree.wallAt(kVein, {60, 0, 20}).distance_mm, -0.1, 1e-9);
  EXPECT_FALSE(VesselTree::make(std::vector{point, twice}));
}

TEST(VesselTree, CaseWithoutNamesIsRefused) {
  EXPECT_THAT(VesselTree::make({}).error().message, testing::HasSubstr("names no vein"));
}

}  // namespace
}  // namespace insonate
