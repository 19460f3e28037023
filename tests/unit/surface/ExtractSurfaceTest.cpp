#include "MeshProbe.h"

#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>

namespace insonate::test {
namespace {

constexpr SurfaceOptions kPlain{.smoothing_mm = 0, .detail_mm = 0};

TEST(ExtractSurface, ABallHasItsAreaVolumeAndShape) {
  LabelMap labels = emptyMap(50, 50, 50);
  const Vec3 center{24.3, 25.1, 24.8};
  addBall(labels, kThyroid, center, 20);
  const Mesh mesh = surfaceOf(labels, kThyroid);
  EXPECT_NEAR(volume_mm3(mesh) / ballVolume_mm3(20), 1, 0.01);
  EXPECT_NEAR(area_mm2(mesh) / ballArea_mm2(20), 1, 0.02);
  EXPECT_TRUE(isClosed(mesh));
  EXPECT_EQ(eulerCharacteristic(mesh), 2);
  EXPECT_GT(worstOutward(mesh, center), 0.9);
  for (std::size_t p = 0; p < mesh.pointCount(); ++p)
    EXPECT_NEAR(norm(point(mesh.points_mm, p) - center), 20, 1) << "a voxel at most from where it should be";
}

TEST(ExtractSurface, SmoothingTakesTheStairsAway) {
  LabelMap labels = emptyMap(50, 50, 50);
  addBall(labels, kVein, {24.3, 25.1, 24.8}, 20);
  const double stairs = area_mm2(surfaceOf(labels, kVein, kPlain)) / ballArea_mm2(20);
  const double smooth = area_mm2(surfaceOf(labels, kVein)) / ballArea_mm2(20);
  EXPECT_GT(stairs, 1.05);
  EXPECT_LT(std::abs(smooth - 1), 0.02);
}

TEST(ExtractSurface, WithoutSmoothingABoxLiesOnTheFacesOfItsVoxels) {
  LabelMap labels = emptyMap(20, 20, 20);
  addBox(labels, kBone, {5, 6, 7}, {14, 13, 12});
  const Mesh mesh = surfaceOf(labels, kBone, kPlain);
  Vec3 low{99, 99, 99}, high{-99, -99, -99};
  for (std::size_t p = 0; p < mesh.pointCount(); ++p)
    for (int a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], point(mesh.points_mm, p)[a]);
      high[a] = std::max(high[a], point(mesh.points_mm, p)[a]);
    }
  EXPECT_EQ(low, (Vec3{4.5, 5.5, 6.5}));
  EXPECT_EQ(high, (Vec3{14.5, 13.5, 12.5}));
  EXPECT_NEAR(volume_mm3(mesh) / (10 * 8 * 6), 1, 0.03);  // its edges are cut
}

TEST(ExtractSurface, LargerBlocksGiveFewerTrianglesInTheSamePlace) {
  LabelMap labels = emptyMap(64, 64, 64);
  const Vec3 center{31, 31.5, 32};
  addBall(labels, kSoftTissue, center, 25);
  const Mesh fine = surfaceOf(labels, kSoftTissue, {.smoothing_mm = 6, .detail_mm = 0});
  const Mesh coarse = surfaceOf(labels, kSoftTissue, {.smoothing_mm = 6, .detail_mm = 3});
  EXPECT_LT(coarse.triangleCount(), fine.triangleCount() / 6);
  EXPECT_NEAR(volume_mm3(coarse) / ballVolume_mm3(25), 1, 0.01);
  EXPECT_NEAR(area_mm2(coarse) / ballArea_mm2(25), 1, 0.02);
  EXPECT_LT(norm(centroid(coarse) - center), 0.2);
  EXPECT_TRUE(isClosed(coarse));
}

TEST(ExtractSurface, ThinWallsAreKeptWhereBlocksAreTooLarge) {
  LabelMap labels = emptyMap(60, 60, 12);
  addBox(labels, kSkin, {4, 4, 5}, {55, 55, 6});
  const Mesh mesh = surfaceOf(labels, kSkin, {.smoothing_mm = 6, .detail_mm = 10});
  EXPECT_NEAR(volume_mm3(mesh) / (52 * 52 * 2), 1, 0.1);
  EXPECT_EQ(eulerCharacteristic(mesh), 2) << "no holes through the wall";
}

TEST(ExtractSurface, AStructureAtTheBorderIsClosedThere) {
  LabelMap labels = emptyMap(30, 30, 30);
  addBall(labels, kMuscle, {0, 15, 29}, 12);
  for (const double detail_mm : {0.0, 2.0}) {
    const Mesh mesh = surfaceOf(labels, kMuscle, {.smoothing_mm = 6, .detail_mm = detail_mm});
    EXPECT_TRUE(isClosed(mesh));
    EXPECT_EQ(eulerCharacteristic(mesh), 2);
    const auto voxels = std::ranges::count(labels.voxels, std::uint8_t{kMuscle});
    EXPECT_NEAR(volume_mm3(mesh) / double(voxels), 1, 0.03);
  }
  LabelMap full = emptyMap(8, 8, 8);
  addBox(full, kFat, {0, 0, 0}, {7, 7, 7});
  EXPECT_TRUE(isClosed(surfaceOf(full, kFat)));
}

TEST(ExtractSurface, SeparatePartsStaySeparate) {
  LabelMap labels = emptyMap(60, 30, 30);
  addBall(labels, kVein, {14, 15, 15}, 8);
  addBall(labels, kVein, {45, 15, 15}, 6);
  const Mesh mesh = surfaceOf(labels, kVein);
  EXPECT_TRUE(isClosed(mesh));
  EXPECT_EQ(eulerCharacteristic(mesh), 4);
  EXPECT_NEAR(volume_mm3(mesh) / (ballVolume_mm3(8) + ballVolume_mm3(6)), 1, 0.02);
}

TEST(ExtractSurface, VoxelsThatMeetAtAnEdgeOrCornerStaySeparate) {
  LabelMap labels = emptyMap(8, 8, 8);
  labels.at(2, 2, 2) = kNerve;
  labels.at(3, 3, 2) = kNerve;
  labels.at(4, 4, 3) = kNerve;
  const Mesh mesh = surfaceOf(labels, kNerve, kPlain);
  EXPECT_TRUE(isClosed(mesh));
  EXPECT_EQ(eulerCharacteristic(mesh), 6);
}

TEST(ExtractSurface, ACavityIsNotPartOfTheVolume) {
  LabelMap labels = emptyMap(50, 50, 50);
  addBall(labels, kBone, {25, 25, 25}, 20);
  addBall(labels, kBackground, {25, 25, 25}, 10);
  const Mesh mesh = surfaceOf(labels, kBone);
  EXPECT_TRUE(isClosed(mesh));
  EXPECT_NEAR(volume_mm3(mesh) / (ballVolume_mm3(20) - ballVolume_mm3(10)), 1, 0.02);
  for (std::size_t p = 0; p < mesh.pointCount(); ++p) {
    const Vec3 away = point(mesh.points_mm, p) - Vec3{25, 25, 25};
    const double cosine = dot(normalized(away), point(mesh.normals, p));
    EXPECT_GT(norm(away) > 15 ? cosine : -cosine, 0.8) << "out of the bone, into the cavity";
  }
}

TEST(ExtractSurface, TouchingStructuresShareTheirBorder) {
  LabelMap labels = emptyMap(40, 30, 30);
  addBox(labels, kArtery, {5, 5, 5}, {19, 24, 24});
  addBox(labels, kVein, {20, 5, 5}, {34, 24, 24});
  const Mesh artery = surfaceOf(labels, kArtery), vein = surfaceOf(labels, kVein);
  EXPECT_TRUE(isClosed(artery));
  EXPECT_TRUE(isClosed(vein));
  EXPECT_NEAR(volume_mm3(artery), volume_mm3(vein), 1);
  int met = 0;
  for (const Mesh* mesh : {&artery, &vein})
    for (std::size_t p = 0; p < mesh->pointCount(); ++p) {
      const Vec3 at = point(mesh->points_mm, p);
      const bool onTheBorder = std::abs(at.x - 19.5) < 2 && std::abs(at.y - 14.5) < 6 && std::abs(at.z - 14.5) < 6;
      if (!onTheBorder) continue;
      ++met;
      EXPECT_NEAR(at.x, 19.5, 0.1);
    }
  EXPECT_GT(met, 200);
}

TEST(ExtractSurface, TheBodyIsAllThatIsLabeled) {
  LabelMap labels = emptyMap(50, 50, 50);
  addBall(labels, kSkin, {25, 25, 25}, 18);
  addBall(labels, kMuscle, {25, 25, 25}, 16);
  addBall(labels, kAirway, {25, 25, 25}, 5);
  const auto mesh = extractBody(labels);
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_NEAR(volume_mm3(*mesh) / ballVolume_mm3(18), 1, 0.01);
  EXPECT_EQ(eulerCharacteristic(*mesh), 2) << "no surfaces inside";
  EXPECT_FALSE(extractBody(emptyMap(5, 5, 5)));
}

TEST(ExtractSurface, OneVoxelIsASmallClosedThingInItsPlace) {
  LabelMap labels = emptyMap(9, 9, 9);
  labels.at(4, 5, 6) = kNerve;
  for (const double smoothing_mm : {0.0, 6.0}) {
    const Mesh mesh = surfaceOf(labels, kNerve, {.smoothing_mm = smoothing_mm, .detail_mm = 1});
    EXPECT_TRUE(isClosed(mesh));
    EXPECT_EQ(eulerCharacteristic(mesh), 2);
    EXPECT_GT(volume_mm3(mesh), 0.1);
    EXPECT_LT(norm(centroid(mesh) - Vec3{4, 5, 6}), 1e-5);
    EXPECT_GT(worstOutward(mesh, {4, 5, 6}), 0.9);
  }
}

TEST(ExtractSurface, AThinNerveKeepsMostOfItsVolume) {
  LabelMap labels = emptyMap(20, 20, 60);
  const double radius_mm = 1.6;
  for (int k = 5; k < 55; ++k)
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 20; ++i)
        if (std::hypot(i - 9.5, j - 9.5) < radius_mm) labels.at(i, j, k) = kNerve;
  const double voxels = double(std::ranges::count(labels.voxels, std::uint8_t{kNerve}));
  const Mesh mesh = surfaceOf(labels, kNerve);
  EXPECT_NEAR(volume_mm3(mesh) / voxels, 1, 0.25);
  EXPECT_EQ(eulerCharacteristic(mesh), 2);
}

TEST(ExtractSurface, OnlyPresentStructuresAreListed) {
  LabelMap labels = emptyMap(4, 4, 4);
  EXPECT_TRUE(structuresIn(labels).empty());
  labels.at(0, 0, 0) = 200;
  labels.at(1, 2, 3) = kSkin;
  EXPECT_THAT(structuresIn(labels), testing::ElementsAre(kSkin, 200));
}

}  // namespace
}  // namespace insonate::test
