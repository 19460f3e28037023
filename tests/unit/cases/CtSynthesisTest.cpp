#include <insonate/cases/CtSynthesis.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>
#include <oneapi/tbb/global_control.h>

#include <cmath>

namespace insonate {
namespace {

VolumeGeometry cube(int n, double spacing_mm) {
  VolumeGeometry g;
  g.size = {n, n, n};
  g.spacing_mm = {spacing_mm, spacing_mm, spacing_mm};
  return g;
}

struct Statistics {
  double mean, sd;
};

/// Statistics of the voxels at least `margin` from the grid's edge that carry a label.
Statistics inside(const CtVolume& ct, const LabelMap& labels, std::uint8_t label, int margin) {
  double sum = 0, squares = 0, n = 0;
  const auto& size = ct.geometry.size;
  for (int k = margin; k < size[2] - margin; ++k)
    for (int j = margin; j < size[1] - margin; ++j)
      for (int i = margin; i < size[0] - margin; ++i)
        if (labels.at(i, j, k) == label) {
          const double v = ct.at(i, j, k);
          sum += v, squares += v * v, ++n;
        }
  return {sum / n, std::sqrt(squares / n - sum / n * sum / n)};
}

TEST(CtSynthesis, TissueHasItsHounsfieldNumber) {
  const struct {
    Label label;
    double low, high;
  } kExpected[] = {{kBackground, -1003, -997}, {kFat, -110, -90}, {kMuscle, 45, 65},
                   {kThyroid, 95, 125},        {kVein, 35, 50},   {kArtery, 35, 55},
                   {kLymphNode, 30, 50}};
  for (const auto& e : kExpected) {
    const LabelMap labels(cube(40, 1), e.label);
    const auto ct = synthesizeCt(labels, {});
    ASSERT_TRUE(ct);
    const Statistics s = inside(*ct, labels, e.label, 0);
    EXPECT_GE(s.mean, e.low) << labelTable()[e.label].name;
    EXPECT_LE(s.mean, e.high) << labelTable()[e.label].name;
  }
}

TEST(CtSynthesis, WideAirIsLungAndATracheaBesideItIsNot) {
  constexpr Label kLung = kBone;  // a number of its own, to measure by
  LabelMap labels(cube(120, 1), kMuscle), parts = labels;
  for (int k = 0; k < 120; ++k)
    for (int j = 0; j < 120; ++j)
      for (int i = 0; i < 120; ++i) {
        const bool lung = i < 70 && j > 10 && j < 110, trachea = std::hypot(i - 90, j - 60) < 9;
        if (lung || trachea) labels.at(i, j, k) = kAirway, parts.at(i, j, k) = lung ? kLung : kAirway;
      }
  const auto ct = synthesizeCt(labels, {.noise_HU = 0, .resolution_FWHM_mm = 0});
  ASSERT_TRUE(ct);
  EXPECT_NEAR(inside(*ct, parts, kLung, 0).mean, -830, 6);
  EXPECT_NEAR(inside(*ct, parts, kAirway, 0).mean, -1000, 3);
}

TEST(CtSynthesis, ContrastFillsTheVesselsOnly) {
  for (const Label label : {kArtery, kVein, kFat}) {
    const LabelMap labels(cube(24, 1), label);
    const auto native = synthesizeCt(labels, {});
    const auto filled = synthesizeCt(labels, {.contrast = CtContrast::kArterial});
    const double rise = inside(*filled, labels, label, 0).mean - inside(*native, labels, label, 0).mean;
    EXPECT_NEAR(rise, label == kArtery ? 205 : label == kVein ? 138 : 0, 5);
  }
}

TEST(CtSynthesis, NoiseHasTheAskedDeviationAndALittleCorrelation) {
  const LabelMap air(cube(48, 1), kBackground);
  const auto ct = synthesizeCt(air, {.noise_HU = 20});
  ASSERT_TRUE(ct);
  const Statistics s = inside(*ct, air, kBackground, 0);
  // Air is at -1000 and nothing goes below -1024, which cuts the lower tail off.
  EXPECT_NEAR(s.sd, 18.4, 1.2);
  double product = 0, square = 0;
  for (int k = 0; k < 48; ++k)
    for (int j = 0; j < 48; ++j)
      for (int i = 0; i < 47; ++i) {
        const double a = ct->at(i, j, k) - s.mean, b = ct->at(i + 1, j, k) - s.mean;
        product += a * b, square += a * a;
      }
  EXPECT_NEAR(product / square, 2.0 / 3, 0.08);  // 1-2-1 smoothing
}

TEST(CtSynthesis, NoiselessMuscleKeepsItsTexture) {
  const LabelMap muscle(cube(48, 1), kMuscle);
  const auto ct = synthesizeCt(muscle, {.noise_HU = 0, .resolution_FWHM_mm = 0});
  ASSERT_TRUE(ct);
  EXPECT_NEAR(inside(*ct, muscle, kMuscle, 0).sd, 8, 2);
}

TEST(CtSynthesis, BoundaryIsBlurredByTheScanner) {
  LabelMap labels(cube(40, 0.5), kBackground);
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 20; i < 40; ++i) labels.at(i, j, k) = kVein;
  const auto ct = synthesizeCt(labels, {.noise_HU = 0, .resolution_FWHM_mm = 2});
  ASSERT_TRUE(ct);
  // The edge lies at x = 19.5 voxels; an ideal edge blurred with sigma 0.849 mm is the normal distribution.
  for (const int i : {17, 19, 20, 22}) {
    const double t = (i - 19.5) * 0.5 / 0.849, expected = -1000 + 1042 * 0.5 * std::erfc(-t / std::sqrt(2.0));
    EXPECT_NEAR(ct->at(i, 20, 20), expected, 25) << i;
  }
}

TEST(CtSynthesis, BoneHasACompactShell) {
  LabelMap labels(cube(60, 0.5), kSoftTissue);
  for (int k = 10; k < 50; ++k)
    for (int j = 10; j < 50; ++j)
      for (int i = 10; i < 50; ++i) labels.at(i, j, k) = kBone;
  const auto ct = synthesizeCt(labels, {.noise_HU = 0});
  ASSERT_TRUE(ct);
  EXPECT_GT(ct->at(12, 30, 30), 700);
  EXPECT_NEAR(ct->at(30, 30, 30), 260, 150);
}

TEST(CtSynthesis, SameSeedGivesSameBytesOnAnyNumberOfThreads) {
  LabelMap labels(cube(32, 0.8), kFat);
  for (std::size_t n = 0; n < labels.voxels.size(); ++n) labels.voxels[n] = n % kLabelCount;
  const auto parallel = synthesizeCt(labels, {.seed = 5});
  oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  const auto serial = synthesizeCt(labels, {.seed = 5});
  EXPECT_TRUE(parallel->voxels == serial->voxels);
  EXPECT_FALSE(synthesizeCt(labels, {.seed = 6})->voxels == serial->voxels);
}

TEST(CtSynthesis, RefusesWhatItCannotDo) {
  const LabelMap labels(cube(8, 1), kFat);
  EXPECT_FALSE(synthesizeCt(labels, {.noise_HU = -1}));
  EXPECT_FALSE(synthesizeCt(labels, {.noise_HU = NAN}));
  EXPECT_FALSE(synthesizeCt(labels, {.resolution_FWHM_mm = 50}));
  LabelMap torn = labels;
  torn.voxels.pop_back();
  EXPECT_FALSE(synthesizeCt(torn, {}));
}

}  // namespace
}  // namespace insonate
