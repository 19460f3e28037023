#include "SimpleNeck.h"

#include <insonate/segmentation/AutoLabel.h>
#include <insonate/tissue/Labels.h>

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <map>

namespace insonate {
namespace {

using test::SimpleNeck;

std::uint8_t labelAt(const LabelMap& labels, Vec3 patient_mm) {
  return sampleNearest(labels, labels.geometry.indexFromPatient() * patient_mm, 255);
}

/// The first label that is not background on the way from a point.
std::uint8_t firstFrom(const LabelMap& labels, Vec3 patient_mm, Vec3 direction) {
  for (double way_mm = 0; way_mm < 50; way_mm += 0.25)
    if (const std::uint8_t label = labelAt(labels, patient_mm + direction * way_mm); label != kBackground) return label;
  return kBackground;
}

const Mat3 kAxial{};
/// Axial with a left-handed stack, as when slices are stored from head to foot.
const Mat3 kAxialDownward{{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, -1}}};
/// i runs head-foot, as in a sagittal stack.
const Mat3 kSagittal{{Vec3{0, 0, -1}, Vec3{0, 1, 0}, Vec3{1, 0, 0}}};

Mat3 tilted() {
  const double c = std::cos(0.3), s = std::sin(0.3);
  return {{Vec3{1, 0, 0}, Vec3{0, c, s}, Vec3{0, -s, c}}};
}

struct Grid {
  const char* name;
  Mat3 direction;
  Vec3 spacing_mm;
};

class AutoLabelOnGrid : public testing::TestWithParam<Grid> {};

TEST_P(AutoLabelOnGrid, FindsEachStructureAtItsPlace) {
  const VolumeGeometry grid = test::gridOver(GetParam().direction, GetParam().spacing_mm);
  const auto labels = autoLabel(SimpleNeck{}.sampledOn(grid), {});
  ASSERT_TRUE(labels) << labels.error().message;
  EXPECT_EQ(labels->geometry, grid);

  EXPECT_EQ(labelAt(*labels, SimpleNeck::kAirway), kAirway);
  EXPECT_EQ(labelAt(*labels, SimpleNeck::kNostril + Vec3{0, 12, 0}), kAirway) << "sealed at the nostril";
  EXPECT_EQ(labelAt(*labels, {0, 0, 0}), kMuscle);
  EXPECT_EQ(labelAt(*labels, {54, 0, 0}), kFat);
  EXPECT_EQ(labelAt(*labels, {-54, 0, 20}), kFat);
  EXPECT_EQ(labelAt(*labels, SimpleNeck::kVertebra + Vec3{7.5, 0, 0}), kBone);
  EXPECT_EQ(labelAt(*labels, SimpleNeck::kVertebra + Vec3{0, 10.5, 0}), kBone) << "marrow";
  EXPECT_EQ(firstFrom(*labels, {-75, 0, 10}, {1, 0, 0}), kSkin);
  EXPECT_EQ(labelAt(*labels, SimpleNeck::kArm), kMuscle) << "the arm hangs on the shoulder";
  EXPECT_EQ(labelAt(*labels, {67, 0, 0}), kBackground) << "air between neck and arm";
  EXPECT_EQ(labelAt(*labels, {0, 76.5, 0}), kBackground) << "couch";
  EXPECT_EQ(labelAt(*labels, {-100, -80, 0}), kBackground);
}

TEST_P(AutoLabelOnGrid, SkinIsClosed) {
  const auto labels =
      autoLabel(SimpleNeck{}.sampledOn(test::gridOver(GetParam().direction, GetParam().spacing_mm)), {});
  ASSERT_TRUE(labels);
  const auto& size = labels->geometry.size;
  const auto bare = [&](std::uint8_t a, std::uint8_t b) {
    return a == kBackground && b != kBackground && b != kSkin && b != kAirway;
  };
  int holes = 0;
  for (int k = 0; k + 1 < size[2]; ++k)
    for (int j = 0; j + 1 < size[1]; ++j)
      for (int i = 0; i + 1 < size[0]; ++i)
        for (const auto other : {labels->at(i + 1, j, k), labels->at(i, j + 1, k), labels->at(i, j, k + 1)})
          holes += bare(labels->at(i, j, k), other) || bare(other, labels->at(i, j, k));
  EXPECT_EQ(holes, 0);
}

INSTANTIATE_TEST_SUITE_P(Grids, AutoLabelOnGrid,
                         testing::Values(Grid{"isotropic", kAxial, {1.5, 1.5, 1.5}},
                                         Grid{"anisotropic", kAxial, {1, 1, 4}},
                                         Grid{"leftHanded", kAxialDownward, {1.2, 1.2, 3}},
                                         Grid{"sagittalStorage", kSagittal, {1.5, 1.5, 2}},
                                         Grid{"oblique", tilted(), {1.2, 1.2, 2}}),
                         [](const auto& grid) { return std::string(grid.param.name); });

TEST(AutoLabel, VolumesAreThoseOfTheSolids) {
  const VolumeGeometry grid = test::gridOver(kAxial, {1, 1, 3});
  const auto labels = autoLabel(SimpleNeck{}.sampledOn(grid), {});
  ASSERT_TRUE(labels);
  std::map<int, double> cm3;
  const Transform patientFromIndex = grid.patientFromIndex();
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const Vec3 p = patientFromIndex * Vec3{double(i), double(j), double(k)};
        if (std::abs(p.z) < 20 && std::hypot(p.x, p.y) < 70) cm3[labels->at(i, j, k)] += 3e-3;
      }
  constexpr double kLength_cm = 3.9;  // 13 slices of 3 mm
  const auto disc = [](double radius_cm) { return M_PI * radius_cm * radius_cm; };
  EXPECT_NEAR(cm3[kAirway], disc(0.9) * kLength_cm, 0.05 * disc(0.9) * kLength_cm);
  EXPECT_NEAR(cm3[kBone], (disc(1.5) - disc(0.6)) * kLength_cm, 0.1 * (disc(1.5) - disc(0.6)) * kLength_cm);
  EXPECT_NEAR(cm3[kSkin], (disc(6) - disc(5.8)) * kLength_cm, 0.2 * (disc(6) - disc(5.8)) * kLength_cm);
  EXPECT_NEAR(cm3[kFat], (disc(5.8) - disc(5)) * kLength_cm, 0.07 * (disc(5.8) - disc(5)) * kLength_cm);
}

TEST(AutoLabel, SkinEndsWhereFatBegins) {
  SimpleNeck thin;
  thin.skin_mm = 1.2, thin.noise_HU = 5;
  const auto labels = autoLabel(thin.sampledOn(test::gridOver(kAxial, {0.8, 0.8, 3})), {});
  ASSERT_TRUE(labels);
  EXPECT_EQ(labelAt(*labels, {-59.5, 0, 0}), kSkin);
  EXPECT_EQ(labelAt(*labels, {-58.2, 0, 0}), kFat) << "within 2 mm of the surface";
}

TEST(AutoLabel, StrongNoiseIsNoBone) {
  SimpleNeck noisy;
  noisy.noise_HU = 60;
  const VolumeGeometry grid = test::gridOver(kAxial, {1, 1, 2});
  const auto labels = autoLabel(noisy.sampledOn(grid), {});
  ASSERT_TRUE(labels);
  double bone_mm3 = 0;
  const Transform patientFromIndex = grid.patientFromIndex();
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i)
        if (const Vec3 p = patientFromIndex * Vec3{double(i), double(j), double(k)}; std::abs(p.z) < 20)
          bone_mm3 += labels->at(i, j, k) == kBone ? 2 : 0;
  const double ring_mm3 = M_PI * (15 * 15 - 6 * 6) * 38;
  EXPECT_NEAR(bone_mm3, ring_mm3, 0.12 * ring_mm3);
}

TEST(AutoLabel, BrightBloodIsNotBone) {
  SimpleNeck neck;
  neck.contrast = true;
  const auto labels = autoLabel(neck.sampledOn(test::gridOver(kAxial, {1, 1, 2})), {});
  ASSERT_TRUE(labels);
  for (const double z : {-30.0, 0.0, 40.0})
    EXPECT_EQ(labelAt(*labels, SimpleNeck::kVessel + Vec3{0, 0, z}), kMuscle) << "z " << z;
  EXPECT_EQ(labelAt(*labels, SimpleNeck::kVertebra + Vec3{7.5, 0, 0}), kBone);
}

TEST(AutoLabel, PaddingIsACutNotSkin) {
  const VolumeGeometry grid = test::gridOver(kAxial, {1.5, 1.5, 3});
  CtVolume ct = SimpleNeck{}.sampledOn(grid);
  const Transform patientFromIndex = grid.patientFromIndex();
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i)
        if ((patientFromIndex * Vec3{double(i), double(j), double(k)}).x < -40) ct.at(i, j, k) = -3024;
  const auto labels = autoLabel(ct, {});
  ASSERT_TRUE(labels);
  EXPECT_EQ(labelAt(*labels, {-45, 0, 0}), kBackground);
  EXPECT_EQ(labelAt(*labels, {-38.5, 0, 0}), kMuscle);
}

class AutoLabelThreads : public testing::TestWithParam<double> {};

TEST_P(AutoLabelThreads, DoNotChangeTheLabels) {
  SimpleNeck neck;
  neck.noise_HU = GetParam();
  const CtVolume ct = neck.sampledOn(test::gridOver(kAxial, {2, 2, 3}));
  const auto onMany = autoLabel(ct, {});
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto onOne = autoLabel(ct, {});
  ASSERT_TRUE(onMany && onOne);
  EXPECT_EQ(onMany->voxels, onOne->voxels);
}

INSTANTIATE_TEST_SUITE_P(Noise, AutoLabelThreads, testing::Values(15.0, 60.0));

}  // namespace
}  // namespace insonate
