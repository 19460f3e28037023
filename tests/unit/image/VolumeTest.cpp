#include <insonate/image/Volume.h>

#include <gtest/gtest.h>

#include <limits>

namespace insonate {
namespace {

CtVolume ramp(std::array<int, 3> size) {
  VolumeGeometry g;
  g.size = size;
  CtVolume volume(g);
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) volume.at(i, j, k) = static_cast<std::int16_t>(10 * i - 7 * j + 100 * k);
  return volume;
}

TEST(SampleLinear, ReproducesALinearFieldExactly) {
  const CtVolume volume = ramp({5, 4, 3});
  for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{4, 3, 2}, Vec3{1.25, 2.5, 0.75}, Vec3{3.999, 0.001, 1}})
    EXPECT_NEAR(sampleLinear(volume, p), 10 * p.x - 7 * p.y + 100 * p.z, 1e-9);
}

TEST(SampleLinear, HoldsTheEdgeOutside) {
  const CtVolume volume = ramp({5, 4, 3});
  EXPECT_EQ(sampleLinear(volume, {-3, 0, 0}), volume.at(0, 0, 0));
  EXPECT_EQ(sampleLinear(volume, {9, 9, 9}), volume.at(4, 3, 2));
  EXPECT_NEAR(sampleLinear(volume, {1.5, -1, 2.5}), 215, 1e-9);
}

TEST(SampleLinear, WorksOnOneSliceAndOneVoxel) {
  EXPECT_NEAR(sampleLinear(ramp({5, 4, 1}), {1.5, 1, 0.4}), 8, 1e-9);
  EXPECT_EQ(sampleLinear(ramp({1, 1, 1}), {7, -7, 0.2}), 0);
}

TEST(SampleLinear, SpansTheWholeRangeOfHounsfieldUnits) {
  CtVolume volume = ramp({2, 1, 1});
  volume.at(0, 0, 0) = std::numeric_limits<std::int16_t>::min();
  volume.at(1, 0, 0) = std::numeric_limits<std::int16_t>::max();
  EXPECT_NEAR(sampleLinear(volume, {0.5, 0, 0}), -0.5, 1e-9);
}

TEST(SampleNearest, RoundsToTheVoxelWhoseCellHoldsThePoint) {
  VolumeGeometry g;
  g.size = {3, 1, 1};
  LabelMap labels(g);
  labels.voxels = {1, 2, 3};
  EXPECT_EQ(sampleNearest(labels, {0.49, 0, 0}), 1);
  EXPECT_EQ(sampleNearest(labels, {0.5, 0, 0}), 2);
  EXPECT_EQ(sampleNearest(labels, {-0.49, 0.49, -0.49}), 1);
}

TEST(SampleNearest, GivesTheOutsideLabelBeyondTheGrid) {
  VolumeGeometry g;
  g.size = {3, 2, 2};
  const LabelMap labels(g, 7);
  EXPECT_EQ(sampleNearest(labels, {-0.51, 0, 0}), 0);
  EXPECT_EQ(sampleNearest(labels, {2.5, 0, 0}, 9), 9);
  EXPECT_EQ(sampleNearest(labels, {1e300, 0, 0}, 9), 9);
  EXPECT_EQ(sampleNearest(labels, {std::numeric_limits<double>::quiet_NaN(), 0, 0}, 9), 9);
}

}  // namespace
}  // namespace insonate
