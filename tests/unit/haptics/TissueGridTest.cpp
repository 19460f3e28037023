#include <insonate/haptics/TissueGrid.h>

#include <gtest/gtest.h>

#include <cmath>

namespace insonate {
namespace {

VolumeGeometry obliqueGrid() {
  VolumeGeometry g;
  g.size = {60, 50, 30};
  g.spacing_mm = {0.8, 0.9, 1.5};
  g.origin_mm = {-10, 5, 20};
  const double c = std::cos(0.4), s = std::sin(0.4);
  g.direction = {{Vec3{c, s, 0}, Vec3{-s, c, 0}, Vec3{0, 0, 1}}};
  return g;
}

TEST(TissueGrid, InterpolatesOnAnObliqueGrid) {
  const auto grid = TissueGrid::make(obliqueGrid(), [](Vec3 p) {
    TissueSample sample;
    sample.distance_mm[0] = static_cast<float>(0.3 * p.x - 0.2 * p.y + 0.5 * p.z);
    sample.label = p.z > 35 ? kBone : kFat;
    return sample;
  });
  ASSERT_TRUE(grid);
  const Vec3 p = (*grid)->geometry().center_mm() + Vec3{3.3, -2.1, 1.7};
  EXPECT_NEAR((*grid)->at(p).distance_mm[0], 0.3 * p.x - 0.2 * p.y + 0.5 * p.z, 0.01);
  const Vec3 up = (*grid)->outward(p, 0);
  const Vec3 slope = normalized(Vec3{0.3, -0.2, 0.5});
  EXPECT_NEAR(dot(up, slope), 1, 1e-3);
  EXPECT_EQ((*grid)->at({0, 0, 1000}).label, kBone);
  EXPECT_EQ((*grid)->at({std::nan(""), 0, 0}).label, (*grid)->at({std::nan(""), 0, 0}).label);
}

TEST(TissueGrid, LabelsBecomeSignedDistances) {
  LabelMap labels(obliqueGrid(), kFat);
  const Vec3 middle = labels.geometry.center_mm();
  const Transform patientFromIndex = labels.geometry.patientFromIndex();
  for (int k = 0; k < 30; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < 60; ++i)
        if (norm(patientFromIndex * Vec3{double(i), double(j), double(k)} - middle) < 8) labels.at(i, j, k) = kVein;
  const auto grid = TissueGrid::fromLabels(labels);
  ASSERT_TRUE(grid);
  double worst = 0;
  for (double r = 5; r < 12; r += 0.5)
    for (double a = 0; a < 6.2; a += 0.3) {
      const Vec3 p = middle + Vec3{r * std::cos(a), r * std::sin(a) * 0.8, r * std::sin(a) * 0.6};
      worst = std::max(worst, std::abs((*grid)->at(p).distance_mm[1] - (r - 8)));
    }
  EXPECT_LT(worst, 0.6);                                // half a voxel of 0.8 x 0.9 x 1.5 mm
  EXPECT_GT((*grid)->at(middle).distance_mm[2], 250);   // no artery anywhere
  EXPECT_LT((*grid)->at(middle).distance_mm[0], -250);  // body everywhere
  EXPECT_EQ((*grid)->at(middle).label, kVein);
}

TEST(TissueGrid, APartIsAsTheWhole) {
  LabelMap labels(obliqueGrid(), kFat);
  for (int k = 0; k < 30; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < 60; ++i)
        if (std::hypot(i - 30, j - 20, 2 * (k - 12)) < 9) labels.at(i, j, k) = kArtery;
  const Vec3 middle = labels.geometry.patientFromIndex() * Vec3{30, 20, 12};
  const auto whole = TissueGrid::fromLabels(labels);
  const auto part = TissueGrid::fromLabels(labels, middle, 14);
  ASSERT_TRUE(whole && part);
  EXPECT_LT((*part)->geometry().voxelCount(), (*whole)->geometry().voxelCount() / 2);
  for (double a = 0; a < 6.2; a += 0.2) {
    const Vec3 p = middle + Vec3{7 * std::cos(a), 6 * std::sin(a), 2 * std::sin(3 * a)};
    EXPECT_NEAR((*part)->at(p).distance_mm[2], (*whole)->at(p).distance_mm[2], 0.02);
    EXPECT_EQ((*part)->at(p).label, (*whole)->at(p).label);
  }
  const auto beyond = TissueGrid::fromLabels(labels, {500, 0, 0}, 14);
  ASSERT_FALSE(beyond);
  EXPECT_EQ(beyond.error().message, "The needle is outside the label map. Move it into the scan.");
}

TEST(TissueGrid, RefusesAGridThatIsTooLarge) {
  VolumeGeometry g;
  g.size = {1000, 1000, 100};
  const auto grid = TissueGrid::make(g, [](Vec3) { return TissueSample{}; });
  ASSERT_FALSE(grid);
  EXPECT_NE(grid.error().message.find("too large for a needle's tissue"), std::string::npos);
}

}  // namespace
}  // namespace insonate
