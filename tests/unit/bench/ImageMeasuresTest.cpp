#include "support/Ssim.h"

#include <insonate/bench/ImageMeasures.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace insonate {
namespace {

template <class GrayAt>
BModeImage paint(int width, int height, double pixel_mm, const GrayAt& grayAt) {
  BModeImage image{width, height, pixel_mm, 0, 0, {}};
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      image.gray.push_back(static_cast<std::uint8_t>(std::clamp(std::lround(grayAt(column, row)), 0L, 255L)));
  return image;
}

/// White noise smoothed by a Gaussian of the given SDs.
std::vector<double> smoothNoise(int width, int height, double lateralSd, double axialSd) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<double> values(std::size_t(width) * height);
  for (double& v : values) v = normal(random);
  const auto blur = [&](bool axial, double sd) {
    std::vector<double> out(values.size());
    const int radius = static_cast<int>(4 * sd);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (int o = -radius; o <= radius; ++o) {
          const int u = axial ? x : (x + o + width) % width, v = axial ? (y + o + height) % height : y;
          out[std::size_t(y) * width + x] += std::exp(-0.5 * o * o / (sd * sd)) * values[std::size_t(v) * width + u];
        }
    values = out;
  };
  blur(false, lateralSd);
  blur(true, axialSd);
  double squares = 0;
  for (const double v : values) squares += v * v;
  for (double& v : values) v /= std::sqrt(squares / double(values.size()));
  return values;
}

TEST(ImageMeasures, SharesAndPercentilesOfARamp) {
  const BModeImage ramp = paint(256, 80, 0.1, [](int column, int) { return column; });
  const GrayStatistics g = grayStatistics(ramp, {0, 0, 256, 80});
  EXPECT_NEAR(g.mean, 127.5, 1e-9);
  EXPECT_NEAR(g.p25, 64, 1);
  EXPECT_NEAR(g.p50, 128, 1);
  EXPECT_NEAR(g.p99, 253, 1);
  EXPECT_NEAR(g.black, 6.0 / 256, 1e-9);
  EXPECT_NEAR(g.blackUpper60, 6.0 / 256, 1e-9);
  EXPECT_NEAR(g.bright, 56.0 / 256, 1e-9);
  EXPECT_NEAR(g.saturated, 6.0 / 256, 1e-9);
  EXPECT_NEAR(g.deepOverShallow, 1, 1e-9);
}

TEST(ImageMeasures, DeepOverShallowComparesTheRightBands) {
  const BModeImage steps = paint(20, 160, 0.1, [](int, int row) {
    return row >= 120 ? 30 : row >= 20 && row < 60 ? 100 : 7;
  });
  EXPECT_NEAR(grayStatistics(steps, {0, 0, 20, 160}).deepOverShallow, 0.3, 1e-9);
}

TEST(ImageMeasures, GrainHasTheWidthOfItsAutocorrelation) {
  // The autocorrelation of noise after a Gaussian of SD s is one of SD s sqrt(2).
  constexpr double kLateral = 5, kAxial = 2.5, kPixel_mm = 0.06;
  const int width = 400, height = 300;
  const std::vector<double> noise = smoothNoise(width, height, kLateral, kAxial);
  // A slow quadratic shade must not count.
  const BModeImage image = paint(width, height, kPixel_mm, [&](int column, int row) {
    const double shade = 20.0 * column / width + 30.0 * row * row / (height * double(height));
    return 90 + shade + 12 * noise[std::size_t(row) * width + column];
  });
  const SpeckleStatistics grain = speckleStatistics(image, {0, 0, width, height});
  EXPECT_NEAR(grain.lateral_mm, 2.3548 * std::sqrt(2.0) * kLateral * kPixel_mm, 0.06);
  EXPECT_NEAR(grain.axial_mm, 2.3548 * std::sqrt(2.0) * kAxial * kPixel_mm, 0.03);
  EXPECT_NEAR(grain.sd, 12, 0.5);
  EXPECT_NEAR(grain.skewness, 0, 0.15);
}

TEST(ImageMeasures, LumenIsComparedWithItsSurroundings) {
  const BModeImage vessel = paint(300, 300, 0.06, [](int column, int row) {
    const double r = std::hypot(column - 150, row - 120);
    if (r < 50) return row < 120 ? 14 : 10;
    return row > 150 && std::abs(column - 150) < 40 ? 120 : 60;
  });
  const Lumen lumen = lumenOf(vessel, {120, 90, 60, 60});
  EXPECT_NEAR(lumen.mean, 12, 0.1);
  EXPECT_NEAR(lumen.sd, 2, 0.1);
  EXPECT_NEAR(lumen.nearMinusFar, 4, 1e-9);
  EXPECT_NEAR(lumen.belowOverSides, 2, 0.1);
  EXPECT_LT(lumen.overSurroundings, 12.0 / 60);
  EXPECT_GT(lumen.overSurroundings, 12.0 / 120);
}

TEST(ImageMeasures, LongAxisVesselsHaveBandsForSurroundings) {
  const BModeImage vessel = paint(300, 200, 0.06, [](int, int row) { return row >= 80 && row < 120 ? 10 : 50; });
  const Lumen lumen = lumenOf(vessel, {50, 82, 200, 36});
  EXPECT_NEAR(lumen.overSurroundings, 0.2, 1e-9);
  EXPECT_TRUE(std::isnan(lumen.belowOverSides));
}

TEST(ImageMeasures, LineIsTheMedianOfTheColumnsBrightest) {
  const BModeImage line = paint(21, 20, 0.1, [](int column, int row) { return row == 10 ? 150 + column : 20; });
  EXPECT_EQ(lineGray(line, {0, 5, 21, 10}), 160);
  EXPECT_EQ(meanGray(line, {0, 0, 21, 5}), 20);
}

TEST(ImageMeasures, SimilarityMeetsItsDefinition) {
  const std::vector<double> noise = smoothNoise(120, 90, 3, 2);
  const auto picture = [&](double gain, double shift) {
    return paint(120, 90, 0.1, [&](int column, int row) {
      return 100 + shift + gain * noise[std::size_t(row) * 120 + column] + 0.3 * column;
    });
  };
  const BModeImage a = picture(20, 0), b = picture(14, 9);
  EXPECT_NEAR(structuralSimilarity(a, a), 1, 1e-12);
  EXPECT_NEAR(structuralSimilarity(a, b), test::ssim(a.gray, b.gray, 120, 90), 1e-9);
  EXPECT_LT(structuralSimilarity(a, b), 0.98);
}

}  // namespace
}  // namespace insonate
