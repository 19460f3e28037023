#include <insonate/image/VoxelBox.h>

#include <gmock/gmock.h>

#include <numeric>

namespace insonate {
namespace {

/// Anisotropic, oblique, left-handed.
VolumeGeometry obliqueGrid() {
  VolumeGeometry g;
  g.size = {20, 10, 30};
  g.spacing_mm = {0.5, 2, 1};
  g.origin_mm = {7, -3, 11};
  g.direction.column = {Vec3{0.8, 0.6, 0}, Vec3{0.6, -0.8, 0}, Vec3{0, 0, 1}};
  return g;
}

TEST(VoxelBox, WithoutLengthAlongOneAxisIsEmpty) {
  EXPECT_TRUE(VoxelBox{}.empty());
  EXPECT_TRUE((VoxelBox{{0, 0, 0}, {5, 5, 0}}.empty()));
  EXPECT_FALSE((VoxelBox{{0, 0, 0}, {1, 1, 1}}.empty()));
}

TEST(VoxelBox, IntersectionOfSeparateBoxesIsEmptyAndUnionIgnoresEmptyOnes) {
  const VoxelBox a{{0, 0, 0}, {4, 4, 4}}, b{{6, 0, 0}, {9, 4, 4}};
  EXPECT_TRUE(intersected(a, b).empty());
  EXPECT_EQ(united(a, b), (VoxelBox{{0, 0, 0}, {9, 4, 4}}));
  EXPECT_EQ(united(a, {}), a);
  EXPECT_EQ(united({}, a), a);
}

TEST(VoxelBox, AroundPointsReachesAsFarAlongEveryAxisInMillimetres) {
  const VolumeGeometry g = obliqueGrid();
  const Vec3 point_mm = g.patientFromIndex() * Vec3{10, 5, 15};
  EXPECT_EQ(boxAround(g, std::array{point_mm}, 2), (VoxelBox{{6, 4, 13}, {15, 7, 18}}));
}

TEST(VoxelBox, AroundPointsStaysInTheGridHoweverFarTheyAre) {
  const VolumeGeometry g = obliqueGrid();
  EXPECT_TRUE(boxAround(g, std::array{Vec3{1e12, 0, 0}}, 5).empty());
  EXPECT_EQ(boxAround(g, std::array{g.origin_mm}, 1e9), boxOf(g));
}

TEST(VoxelBox, GrownTakesWholeVoxelsWithinTheGrid) {
  const VolumeGeometry g = obliqueGrid();
  EXPECT_EQ(grown({{2, 2, 2}, {3, 3, 3}}, g, 1.5), (VoxelBox{{0, 1, 0}, {6, 4, 5}}));
  EXPECT_TRUE(grown({}, g, 3).empty());
}

TEST(VoxelBox, CroppedVoxelsLieWhereTheyLayInThePatient) {
  Volume<int> volume(obliqueGrid());
  std::iota(volume.voxels.begin(), volume.voxels.end(), 0);
  const VoxelBox box{{3, 1, 4}, {8, 6, 10}};
  const Volume<int> part = cropped(volume, box);
  ASSERT_EQ(part.voxels.size(), 5u * 5 * 6);
  for (int k = 0; k < 6; ++k)
    for (int j = 0; j < 5; ++j)
      for (int i = 0; i < 5; ++i) {
        ASSERT_EQ(part.at(i, j, k), volume.at(i + 3, j + 1, k + 4));
        const Vec3 here = part.geometry.patientFromIndex() * Vec3{double(i), double(j), double(k)};
        const Vec3 there = volume.geometry.patientFromIndex() * Vec3{i + 3.0, j + 1.0, k + 4.0};
        ASSERT_LT(norm(here - there), 1e-9);
      }
}

}  // namespace
}  // namespace insonate
