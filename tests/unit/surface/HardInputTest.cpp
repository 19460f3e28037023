#include "MeshProbe.h"

#include <insonate/core/Hash.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>

#include <limits>
#include <string>

namespace insonate::test {
namespace {

using testing::HasSubstr;

std::string refusalOf(const LabelMap& labels, std::uint8_t label, const SurfaceOptions& options = {}) {
  const auto mesh = extractSurface(labels, label, options);
  EXPECT_FALSE(mesh);
  return mesh ? "" : mesh.error().message;
}

TEST(ExtractSurfaceRefuses, BackgroundMissingLabelsAndNames) {
  const LabelMap labels = emptyMap(5, 5, 5);
  EXPECT_THAT(refusalOf(labels, kBackground), HasSubstr("background"));
  EXPECT_THAT(refusalOf(labels, kThyroid), HasSubstr("thyroid (label 8)"));
  EXPECT_THAT(refusalOf(labels, 200), HasSubstr("label 200"));
}

TEST(ExtractSurfaceRefuses, OptionsAndGridsThatAreNone) {
  LabelMap labels = emptyMap(5, 5, 5);
  labels.at(2, 2, 2) = kBone;
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {-1.0, 101.0, nan, infinity}) {
    EXPECT_THAT(refusalOf(labels, kBone, {.smoothing_mm = bad}), HasSubstr("smoothing_mm"));
    EXPECT_THAT(refusalOf(labels, kBone, {.detail_mm = bad}), HasSubstr("detail_mm"));
  }
  LabelMap cut = labels;
  cut.voxels.pop_back();
  EXPECT_THAT(refusalOf(cut, kBone), HasSubstr("124 voxels"));
  LabelMap flat = labels;
  flat.geometry.spacing_mm.y = 0;
  EXPECT_FALSE(refusalOf(flat, kBone).empty());
}

TEST(ExtractSurfaceRefuses, WhenCancelledAtAnyTime) {
  LabelMap labels = emptyMap(40, 40, 40);
  addBall(labels, kBone, {20, 20, 20}, 15);
  int reports = 0;
  double last = 0;
  const Progress count = [&](std::string_view doing, double fraction) {
    EXPECT_THAT(std::string(doing), HasSubstr("bone"));
    EXPECT_GE(fraction, last);
    last = fraction;
    ++reports;
    return true;
  };
  ASSERT_TRUE(extractSurface(labels, kBone, {}, count));
  EXPECT_EQ(last, 1);
  EXPECT_GT(reports, 4);
  for (int stopAt = 1; stopAt <= reports; ++stopAt) {
    int seen = 0;
    const auto mesh = extractSurface(labels, kBone, {}, [&](std::string_view, double) { return ++seen < stopAt; });
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().message, kCancelled);
    EXPECT_EQ(seen, stopAt) << "nothing is asked after a no";
  }
}

TEST(ExtractSurfaceHardInput, NoiseIsClosedToo) {
  LabelMap labels = emptyMap(24, 20, 22);
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    for (std::size_t v = 0; v < labels.voxels.size(); ++v)
      labels.voxels[v] = hashNode(int(v), 0, 0, seed) % 5 < seed ? kFat : kMuscle;
    for (const double smoothing_mm : {0.0, 6.0})
      for (const double detail_mm : {0.0, 2.0}) {
        const Mesh mesh = surfaceOf(labels, kFat, {.smoothing_mm = smoothing_mm, .detail_mm = detail_mm});
        EXPECT_TRUE(isClosed(mesh)) << "seed " << seed;
        EXPECT_TRUE(std::ranges::all_of(mesh.points_mm, [](float x) { return std::isfinite(x); }));
        EXPECT_TRUE(std::ranges::all_of(mesh.normals, [](float x) { return std::isfinite(x); }));
      }
  }
}

TEST(ExtractSurfaceHardInput, TheSurfaceStaysWithinAVoxelHoweverMuchItIsSmoothed) {
  LabelMap labels = emptyMap(30, 30, 30);
  addBox(labels, kBone, {5, 5, 5}, {20, 20, 6});
  addBall(labels, kBone, {15, 15, 18}, 7.3);
  const Mesh sharp = surfaceOf(labels, kBone, {.smoothing_mm = 0, .detail_mm = 0});
  const Mesh round = surfaceOf(labels, kBone, {.smoothing_mm = 100, .detail_mm = 0});
  ASSERT_EQ(sharp.triangles, round.triangles);
  for (std::size_t c = 0; c < sharp.points_mm.size(); ++c)
    ASSERT_NEAR(sharp.points_mm[c], round.points_mm[c], 0.75 + 1e-4);
}

TEST(ExtractSurfaceHardInput, ASingleSliceAndASingleVoxelOfAMap) {
  LabelMap slice = emptyMap(20, 20, 1);
  addBox(slice, kVein, {0, 0, 0}, {19, 19, 0});
  EXPECT_TRUE(isClosed(surfaceOf(slice, kVein)));
  LabelMap voxel = emptyMap(1, 1, 1);
  voxel.at(0, 0, 0) = 255;
  EXPECT_TRUE(isClosed(surfaceOf(voxel, 255)));
}

TEST(ExtractSurfaceHardInput, SameMeshEachTime) {
  LabelMap labels = emptyMap(40, 40, 40);
  addBall(labels, kBone, {20, 20, 20}, 15);
  const Mesh once = surfaceOf(labels, kBone), again = surfaceOf(labels, kBone);
  EXPECT_EQ(once.points_mm, again.points_mm);
  EXPECT_EQ(once.triangles, again.triangles);
}

}  // namespace
}  // namespace insonate::test
