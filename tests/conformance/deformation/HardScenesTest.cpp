#include "HardScene.h"

#include <limits>
#include <random>

namespace insonate::test {
namespace {

using HardScenes = HardScene;

TEST_F(HardScenes, NearlyIncompressible) {
  for (MechanicalTissue& tissue : table.tissues) tissue.poisson = 0.499;
  for (const double press_mm : {1.0, 3.0, 6.0}) EXPECT_TRUE(ask(press_mm).converged) << press_mm;
}

TEST_F(HardScenes, BoneBesideAVeinInTheTableOfTheThesis) {
  table = loadMechanicalTable("thesis").value();
  plane.tissue.blocks.push_back({0, 5, 6, 25, kBone});  // a millimeter from the vein
  for (const double press_mm : {1.0, 2.0, 4.0}) EXPECT_TRUE(ask(press_mm).converged) << press_mm;
  table.tissues[kBone].kind = Mechanics::Solid;
  table.tissues[kBone].young_kPa = 14e6;
  make();
  for (const double press_mm : {1.0, 2.0, 4.0}) EXPECT_TRUE(ask(press_mm).converged) << press_mm;
}

TEST_F(HardScenes, CollapseAndRelease) {
  ask(1);
  const Deformation first = answer;
  for (double press_mm = 2; press_mm <= 12; ++press_mm) ask(press_mm);
  EXPECT_LT(areaRatio(answer, kVein), 0.25);
  EXPECT_GT(areaRatio(answer, kVein), 0.03);
  for (double press_mm = 11; press_mm >= 1; --press_mm) ask(press_mm);
  EXPECT_NEAR(areaRatio(answer, kVein), areaRatio(first, kVein), 0.01);
  EXPECT_NEAR(answer.force_N, first.force_N, 0.02 * first.force_N);
  EXPECT_FALSE(ask(0).moved);
}

TEST_F(HardScenes, AJumpOfTenMillimetres) {
  ask(0);
  ask(10);
  for (int k = 0; k < 3; ++k) ask(10);
  const double there = areaRatio(answer, kVein);
  ask(0);
  EXPECT_FALSE(answer.moved);
  for (double press_mm = 1; press_mm <= 10; ++press_mm) ask(press_mm);
  EXPECT_NEAR(areaRatio(answer, kVein), there, 0.02);
}

TEST_F(HardScenes, RandomMoves) {
  std::mt19937 random(5);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int k = 0; k < 300; ++k) {
    plane.tissue.slide_mm = uniform(-15, 15);
    plane.turn_deg = uniform(-10, 10);
    input.force_N = k % 3 == 0 ? uniform(0, 3) : 0;
    input.pressure.vein_kPa = uniform(0.2, 1.5);
    ask(k % 3 == 0 ? 0 : uniform(-2, 7));
  }
  EXPECT_LT(notConverged, 30);
}

TEST_F(HardScenes, OffTheBodyAndInsideIt) {
  plane.tissue.rightEnd_mm = 0;  // half of the face hangs in the air
  for (const double press_mm : {1.0, 4.0, 7.0}) ask(press_mm);
  plane.tissue.rightEnd_mm = -200;
  EXPECT_FALSE(ask(3).moved);
  input.force_N = 5;
  ask(0);
  input.force_N = 0;
  plane.tissue = neckScene();
  make();
  for (const double turn_deg : {30.0, 45.0, 60.0, -60.0}) {
    plane.turn_deg = turn_deg;
    for (const double press_mm : {0.0, 2.0, 5.0}) ask(press_mm);
  }
  plane.turn_deg = 0;
  for (const double press_mm : {25.0, 40.0, 70.0}) ask(press_mm);
  EXPECT_TRUE(ask(2).converged);  // and back to what is sane
}

TEST_F(HardScenes, AirBackgroundAndUnknownLabels) {
  plane.tissue.blocks.push_back({-3, 0, 3, 60, kAirway});
  for (const double press_mm : {1.0, 4.0}) ask(press_mm);
  plane.tissue.blocks.back().label = 200;
  for (const double press_mm : {1.0, 4.0}) EXPECT_TRUE(ask(press_mm).converged);
  table = loadMechanicalTable("thesis").value();  // whose background is rigid
  plane.tissue.blocks.back().label = kBackground;
  make();
  for (const double press_mm : {1.0, 3.0}) ask(press_mm);
}

TEST_F(HardScenes, AVesselOfOneVoxel) {
  plane.tissue.circles = {{-4, 10, 0.25, kVein}, {5, 10, 0.25, kArtery}};
  for (const double press_mm : {0.0, 2.0, 6.0}) EXPECT_TRUE(ask(press_mm).converged) << press_mm;
}

TEST_F(HardScenes, ForcesOfAllKinds) {
  for (const double force_N : {0.0, -1.0, 1e-6, 0.1}) {
    input.force_N = force_N;
    EXPECT_TRUE(ask(0).converged) << force_N;
    EXPECT_NEAR(answer.force_N, std::max(force_N, 0.0), 0.01);
  }
  plane.tissue.blocks = {{-100, 6, 100, 80, kBone}};
  plane.tissue.circles.clear();
  make();
  for (const double force_N : {1.0, 20.0, 300.0}) {
    input.force_N = force_N;
    ask(0);
    EXPECT_LT(answer.faceShift_mm, 6) << force_N;
  }
}

TEST_F(HardScenes, RandomTissue) {
  std::mt19937 random(7);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int k = 0; k < 60; ++k) {
    for (const std::uint8_t label : {kSkin, kFat, kMuscle, kSoftTissue})
      table.tissues[label].young_kPa = std::pow(10, uniform(0, 2.5));
    plane.tissue = {};
    plane.tissue.skinRadius_mm = k % 2 == 0 ? 0 : uniform(40, 90);
    plane.tissue.layers = {{uniform(0.5, 3), kSkin}, {uniform(1, 8), kFat}};
    plane.tissue.below = k % 3 == 0 ? kMuscle : kSoftTissue;
    plane.tissue.circles = {{uniform(-14, -4), uniform(8, 25), uniform(0.5, 7), kVein},
                            {uniform(6, 15), uniform(8, 25), uniform(0.5, 4), kArtery}};
    if (k % 4 == 0) plane.tissue.blocks = {{uniform(-3, 0), uniform(8, 25), uniform(1, 4), 60, kBone}};
    input.face.radius_mm = k % 5 == 0 ? 50 : 0;
    input.face.sticking = k % 7 == 0;
    make();
    for (int frame = 0; frame < 3; ++frame) {
      input.force_N = k % 2 == 0 ? uniform(0.1, 3) : 0;
      ask(k % 2 == 0 ? 0 : uniform(0, 7));
    }
  }
  EXPECT_LT(notConverged, 36);
}

}  // namespace
}  // namespace insonate::test
