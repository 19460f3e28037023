#include <insonate/image/VolumeGeometry.h>

#include <gtest/gtest.h>

#include <limits>

namespace insonate {
namespace {

/// 20 degrees about x, then a left-handed k axis, anisotropic as a neck CT is.
VolumeGeometry oblique() {
  const double c = std::cos(0.35), s = std::sin(0.35);
  VolumeGeometry g;
  g.size = {512, 300, 99};
  g.spacing_mm = {0.977, 0.977, 4.25};
  g.origin_mm = {-250, -180, 33.5};
  g.direction = {{Vec3{1, 0, 0}, Vec3{0, c, s}, Vec3{0, s, -c}}};
  return g;
}

TEST(VolumeGeometry, FirstVoxelIsTheOriginAndStepsFollowTheDirections) {
  const VolumeGeometry g = oblique();
  const Transform t = g.patientFromIndex();
  EXPECT_EQ(t * Vec3{}, g.origin_mm);
  const Vec3 step = t * Vec3{0, 0, 1} - t * Vec3{};
  EXPECT_NEAR(norm(step), 4.25, 1e-12);
  EXPECT_NEAR(dot(step, g.direction.column[2]), 4.25, 1e-12);
}

TEST(VolumeGeometry, IndexFromPatientIsTheInverseOnAnObliqueLeftHandedGrid) {
  const VolumeGeometry g = oblique();
  const Vec3 index{17.25, 3.5, 98};
  const Vec3 back = g.indexFromPatient() * (g.patientFromIndex() * index);
  EXPECT_NEAR(norm(back - index), 0, 1e-9);
}

TEST(VolumeGeometry, CenterIsHalfwayBetweenOppositeCorners) {
  const VolumeGeometry g = oblique();
  const Transform t = g.patientFromIndex();
  EXPECT_NEAR(norm(g.center_mm() - (t * Vec3{} + t * Vec3{511, 299, 98}) * 0.5), 0, 1e-9);
}

TEST(VolumeGeometry, OffsetsAreDenseWithIFastest) {
  VolumeGeometry g;
  g.size = {3, 4, 5};
  std::size_t expected = 0;
  for (int k = 0; k < 5; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 3; ++i) EXPECT_EQ(g.offset(i, j, k), expected++);
  EXPECT_EQ(g.voxelCount(), expected);
  EXPECT_FALSE(g.contains(3, 0, 0));
  EXPECT_FALSE(g.contains(0, -1, 0));
  EXPECT_TRUE(g.contains(2, 3, 4));
}

TEST(VolumeGeometry, VoxelCountDoesNotOverflowInt) {
  VolumeGeometry g;
  g.size = {2000, 2000, 1000};
  EXPECT_EQ(g.voxelCount(), 4'000'000'000U);
}

TEST(SameGrid, ForgivesWhatAFileFormatLosesAndNothingMore) {
  const VolumeGeometry g = oblique();
  VolumeGeometry rounded = g;
  rounded.spacing_mm.x += 1e-5;
  EXPECT_TRUE(sameGrid(g, rounded));

  VolumeGeometry shifted = g, stretched = g, cropped = g, mirrored = g;
  shifted.origin_mm.y += 0.2;
  stretched.spacing_mm.x += 0.001;
  cropped.size[2] -= 1;
  mirrored.direction.column[0] = -mirrored.direction.column[0];
  EXPECT_FALSE(sameGrid(g, shifted));
  EXPECT_FALSE(sameGrid(g, stretched));
  EXPECT_FALSE(sameGrid(g, cropped));
  EXPECT_FALSE(sameGrid(g, mirrored));
}

TEST(ValidateGeometry, AcceptsEitherHandednessAndASingleSlice) {
  EXPECT_TRUE(validate(oblique()));
  VolumeGeometry slice = oblique();
  slice.size[2] = 1;
  EXPECT_TRUE(validate(slice));
}

TEST(ValidateGeometry, RefusesWhatIsNoGrid) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](const auto& spoil, std::string_view says) {
    VolumeGeometry g = oblique();
    spoil(g);
    const auto result = validate(g);
    ASSERT_FALSE(result) << says;
    EXPECT_NE(result.error().message.find(says), std::string::npos) << result.error().message;
  };
  refused([](VolumeGeometry& g) { g.size[1] = 0; }, "0 voxels");
  refused([](VolumeGeometry& g) { g.size[1] = -4; }, "-4 voxels");
  refused([](VolumeGeometry& g) { g.spacing_mm.z = 0; }, "spacing");
  refused([](VolumeGeometry& g) { g.spacing_mm.z = -4.25; }, "spacing");
  refused([&](VolumeGeometry& g) { g.spacing_mm.x = nan; }, "spacing");
  refused([&](VolumeGeometry& g) { g.origin_mm.x = nan; }, "position");
  refused([](VolumeGeometry& g) { g.direction.column[1] = {0.1, 1, 0}; }, "right angles");
  refused([&](VolumeGeometry& g) { g.direction.column[1].y = nan; }, "right angles");
  refused([](VolumeGeometry& g) { g.size = {100000, 100000, 100000}; }, "more voxels");
}

TEST(CheckVoxelSize, RefusesWhatNoScannerMakesAndNamesIt) {
  EXPECT_TRUE(checkVoxelSize({0.05, 1, 25}));
  const auto metres = checkVoxelSize({1, 0.0015, 1});
  ASSERT_FALSE(metres);
  EXPECT_NE(metres.error().message.find("0.0015 mm"), std::string::npos) << metres.error().message;
  EXPECT_NE(metres.error().message.find("axis 2"), std::string::npos);
  EXPECT_NE(metres.error().message.find("meters?"), std::string::npos);
  EXPECT_FALSE(checkVoxelSize({1, 1, 500}));
  EXPECT_FALSE(checkVoxelSize({std::numeric_limits<double>::quiet_NaN(), 1, 1}));
}

}  // namespace
}  // namespace insonate
