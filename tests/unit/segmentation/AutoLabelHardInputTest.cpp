#include "SimpleNeck.h"

#include <insonate/segmentation/AutoLabel.h>
#include <insonate/tissue/Labels.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace insonate {
namespace {

using test::SimpleNeck;

VolumeGeometry cube(int n, Vec3 spacing_mm = {2, 2, 2}) {
  VolumeGeometry g;
  g.size = {n, n, n};
  g.spacing_mm = spacing_mm;
  return g;
}

/// Soft tissue with air in front of it.
CtVolume blockInAir(const VolumeGeometry& g) {
  CtVolume ct(g, 40);
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1] / 4; ++j)
      for (int i = 0; i < g.size[0]; ++i) ct.at(i, j, k) = -1000;
  return ct;
}

TEST(AutoLabelHardInput, AllAirIsRefusedWithASentence) {
  const auto labels = autoLabel(CtVolume(cube(24), -1000), {});
  ASSERT_FALSE(labels);
  EXPECT_NE(labels.error().message.find("No body"), std::string::npos);
}

TEST(AutoLabelHardInput, AllPaddingIsRefused) {
  EXPECT_FALSE(autoLabel(CtVolume(cube(24), std::numeric_limits<std::int16_t>::min()), {}));
}

TEST(AutoLabelHardInput, ACouchAloneIsNoBody) {
  CtVolume ct(cube(40), -1000);
  for (int k = 0; k < 40; ++k)
    for (int i = 0; i < 40; ++i) ct.at(i, 30, k) = 200;
  EXPECT_FALSE(autoLabel(ct, {}));
}

TEST(AutoLabelHardInput, WithoutAirItIsNoCt) {
  for (const int hu : {0, 40, -299, int(std::numeric_limits<std::int16_t>::max())}) {
    const auto labels = autoLabel(CtVolume(cube(24), static_cast<std::int16_t>(hu)), {});
    ASSERT_FALSE(labels) << hu;
    EXPECT_NE(labels.error().message.find("no air"), std::string::npos);
  }
  CtVolume labelMap(cube(24));
  for (std::size_t v = 0; v < labelMap.voxels.size(); ++v) labelMap.voxels[v] = static_cast<std::int16_t>(v % 60);
  EXPECT_NE(autoLabel(labelMap, {}).error().message.find("label map"), std::string::npos);
}

TEST(AutoLabelHardInput, NearlyAllOneTissueIsNoPatient) {
  CtVolume ct(cube(24), 40);
  ct.at(12, 12, 12) = -1000;
  const auto labels = autoLabel(ct, {});
  ASSERT_FALSE(labels);
  EXPECT_NE(labels.error().message.find("muscle"), std::string::npos) << labels.error().message;
}

TEST(AutoLabelHardInput, OneSliceIsLabeled) {
  VolumeGeometry grid = test::gridOver({}, {1, 1, 3});
  grid.origin_mm.z = 0;
  grid.size[2] = 1;
  const auto labels = autoLabel(SimpleNeck{}.sampledOn(grid), {});
  ASSERT_TRUE(labels) << labels.error().message;
  const auto at = [&](Vec3 p) { return sampleNearest(*labels, grid.indexFromPatient() * p, 255); };
  EXPECT_EQ(at(SimpleNeck::kAirway), kAirway);
  EXPECT_EQ(at({0, 0, 0}), kMuscle);
  EXPECT_EQ(at({-59.2, 0, 0}), kSkin);
  EXPECT_EQ(at({0, 76.5, 0}), kBackground);
}

TEST(AutoLabelHardInput, OneVoxelIsRefused) {
  EXPECT_FALSE(autoLabel(CtVolume(cube(1), 40), {}));
  EXPECT_FALSE(autoLabel(CtVolume(cube(1), -1000), {}));
}

TEST(AutoLabelHardInput, RandomExtremesGiveOnlyKnownLabels) {
  CtVolume ct(cube(20));
  for (std::size_t v = 0; v < ct.voxels.size(); ++v)
    ct.voxels[v] = static_cast<std::int16_t>(hash32(static_cast<std::uint32_t>(v)) >> 16);
  const auto labels = autoLabel(ct, {});
  if (labels) {
    EXPECT_LT(*std::ranges::max_element(labels->voxels), kLabelCount);
  }
}

TEST(AutoLabelHardInput, VoxelsOfVeryDifferentSizeDoNotMatter) {
  for (const Vec3 spacing : {Vec3{0.05, 3, 3}, Vec3{3, 3, 0.05}, Vec3{20, 20, 20}})
    EXPECT_TRUE(autoLabel(blockInAir(cube(16, spacing)), {})) << spacing.x;
}

TEST(AutoLabelHardInput, ABadGridIsRefused) {
  CtVolume ct(cube(8), 40);
  ct.geometry.spacing_mm.x = 0;
  EXPECT_FALSE(autoLabel(ct, {}));
  CtVolume cut(cube(8), 40);
  cut.voxels.resize(100);
  const auto labels = autoLabel(cut, {});
  ASSERT_FALSE(labels);
  EXPECT_NE(labels.error().message.find("100 voxels"), std::string::npos);
}

TEST(AutoLabelHardInput, CancelsAtAnyMoment) {
  const CtVolume ct = SimpleNeck{}.sampledOn(test::gridOver({}, {3, 3, 5}));
  int calls = 0;
  ASSERT_TRUE(autoLabel(ct, [&](std::string_view, double) { return ++calls, true; }));
  for (int stop = 1; stop <= calls; stop += std::max(1, calls / 12)) {
    int heard = 0;
    const auto labels = autoLabel(ct, [&](std::string_view, double) { return ++heard < stop; });
    ASSERT_FALSE(labels);
    EXPECT_EQ(labels.error().message, kCancelled);
    EXPECT_EQ(heard, stop) << "nothing is reported after the refusal";
  }
}

TEST(AutoLabelHardInput, ProgressNeverGoesBack) {
  double last = 0;
  const auto labels =
      autoLabel(SimpleNeck{}.sampledOn(test::gridOver({}, {3, 3, 5})), [&](std::string_view doing, double f) {
        EXPECT_FALSE(doing.empty());
        EXPECT_GE(f, last);
        EXPECT_LE(f, 1);
        last = f;
        return true;
      });
  ASSERT_TRUE(labels);
  EXPECT_GT(last, 0.9);
}

}  // namespace
}  // namespace insonate
