#include "DisplaySupport.h"
#include "SpeckleFrame.h"

#include <insonate/ultrasound/PointSpread.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace insonate {
namespace {

using test::bareSettings;

/// Amplitudes that lead to the noise of an image without echoes, on the beam grid: width and height are chosen so that
/// pixels are scanlines and samples, and the gray map is a straight line in dB.
class ElectronicNoise : public testing::Test {
 protected:
  static constexpr int kLines = 380, kSamples = 400;

  ElectronicNoise() {
    settings = bareSettings(probe);
    settings.effects.noise = true;
    settings.noise_dB = 0;
    settings.dynamicRange_dB = 120;
    settings.scanlines = settings.width = kLines;
    settings.samples = settings.height = kSamples;
  }

  std::vector<std::vector<double>> amplitudes(double echo_dB, unsigned seed) const {
    EnvelopeFrame frame = test::uniformFrame(probe, settings, echo_dB);
    BModeImage image;
    Display(probe, settings).process(frame, image, seed);
    EXPECT_NEAR(image.pixel_mm, 0.1, 1e-9);
    std::vector<std::vector<double>> rows;
    for (int row = 2; row + 2 < image.height; ++row) {
      rows.emplace_back();
      for (int column = 2; column + 2 < image.width; ++column) {
        const double level_dB = image.gray[std::size_t(row) * image.width + column] / 255.0 * 120 + 39.5 - 120;
        rows.back().push_back(std::pow(10, level_dB / 20));
      }
    }
    return rows;
  }

  Probe probe = *loadProbe("linear");
  ImagingSettings settings;
};

using Rows = std::vector<std::vector<double>>;

double meanOf(const Rows& rows, double power) {
  double sum = 0, count = 0;
  for (const auto& row : rows)
    for (const double a : row) sum += std::pow(a, power), ++count;
  return sum / count;
}

/// Correlation of amplitudes apart by so many rows and columns.
double correlation(const Rows& a, const Rows& b, int rows, int columns) {
  const double meanA = meanOf(a, 1), meanB = meanOf(b, 1);
  double ab = 0, aa = 0, bb = 0;
  for (std::size_t r = 0; r + rows < a.size(); ++r)
    for (std::size_t c = 0; c + columns < a[r].size(); ++c) {
      const double x = a[r][c] - meanA, y = b[r + rows][c + columns] - meanB;
      ab += x * y, aa += x * x, bb += y * y;
    }
  return ab / std::sqrt(aa * bb);
}

TEST_F(ElectronicNoise, WithoutEchoesItIsRayleighOfTheLevelThatIsSet) {
  const Rows noise = amplitudes(-200, 1);
  EXPECT_NEAR(meanOf(noise, 2), 1, 0.03);
  const double mean = meanOf(noise, 1);
  EXPECT_NEAR(mean / std::sqrt(meanOf(noise, 2) - mean * mean), 1.91, 0.03);
}

/// Rice: the powers of echo and noise add, E a^2 = s^2 + n^2, and E a^4 = s^4 + 4 s^2 n^2 + 2 n^4.
TEST_F(ElectronicNoise, ItAddsToAnEchoAsAComplexNumber) {
  const Rows both = amplitudes(6, 2);
  const double s2 = std::pow(10, 0.6);
  EXPECT_NEAR(meanOf(both, 2), s2 + 1, 0.1);
  EXPECT_NEAR(meanOf(both, 4), s2 * s2 + 4 * s2 + 2, 0.05 * (s2 * s2 + 4 * s2 + 2));
}

TEST_F(ElectronicNoise, ItIsAsWideAsThePulseAlongAScanlineAndIndependentAcross) {
  const Rows noise = amplitudes(-200, 3);
  const double pulse_mm = axialFwhm_mm(probe, settings);
  // Correlation of the complex noise: exp(-2 ln 2 (z / pulse)^2); that of its magnitude is close to the square.
  for (const int rows : {1, 2, 3}) {
    const double z = 0.1 * rows / pulse_mm;
    EXPECT_NEAR(correlation(noise, noise, rows, 0), std::exp(-4 * std::log(2.0) * z * z), 0.05) << rows;
  }
  EXPECT_NEAR(correlation(noise, noise, 6, 0), 0, 0.03);
  for (const int columns : {1, 2, 8}) EXPECT_NEAR(correlation(noise, noise, 0, columns), 0, 0.03) << columns;
}

TEST_F(ElectronicNoise, ASeedIsAFrame) {
  const Rows one = amplitudes(-200, 4);
  EXPECT_EQ(one, amplitudes(-200, 4));
  EXPECT_NEAR(correlation(one, amplitudes(-200, 5), 0, 0), 0, 0.03) << "other frames have other noise";
  settings.time_s = 0.001;
  EXPECT_NEAR(correlation(one, amplitudes(-200, 4), 0, 0), 0, 0.03) << "and so have other times";
}

TEST_F(ElectronicNoise, LooksAreReceivedOneAfterAnother) {
  settings.looks = 3;
  const Rows noise = amplitudes(-200, 6);
  const double mean = meanOf(noise, 1);
  EXPECT_NEAR(mean, std::sqrt(std::numbers::pi) / 2, 0.02) << "their mean is that of one";
  EXPECT_NEAR(mean / std::sqrt(meanOf(noise, 2) - mean * mean), 1.91 * std::sqrt(3.0), 0.1);
}

/// Szabo and Lewin 2013: 60 cm MHz. Tissue is taken that the built-in TGC levels.
TEST_F(ElectronicNoise, SpeckleDrownsAtThePenetrationDepth) {
  settings = bareSettings(probe);
  settings.effects.attenuation = true;
  for (const double frequency_MHz : {7.5, 12.0}) {
    settings.frequency_MHz = frequency_MHz;
    settings.depth_mm = 90;
    settings.gain_dB = -10;
    const double slope_dBpmm = kTgc_dBpcmMHz * frequency_MHz / 10, penetration_mm = 600 / frequency_MHz;
    const auto grayAtDepth = [&](double echo_dB, bool noise, double depth_mm) {
      settings.effects.noise = noise;
      const EnvelopeFrame frame =
          test::frameOf(probe, settings, [=](double, double z) { return echo_dB - slope_dBpmm * z; });
      const BModeImage image = test::display(probe, settings, frame);
      double sum = 0;
      for (double x = -10; x <= 10; x += 0.1)
        for (double z = depth_mm - 1; z < depth_mm + 1; z += 0.1) sum += test::grayAt(image, x, z);
      return sum / (201 * 20);
    };
    const double speckle = grayAtDepth(0, false, penetration_mm);
    EXPECT_NEAR(grayAtDepth(-200, true, penetration_mm), speckle - 2.5 * 255 / 60, 3)
        << "the logarithm of a Rayleigh amplitude lies 2.5 dB under that of its RMS";
    EXPECT_EQ(grayAtDepth(-200, true, 10), 0) << "nothing is seen of it near the face";
    EXPECT_NEAR(grayAtDepth(0, true, 10), grayAtDepth(0, false, 10), 0.5);
  }
}

TEST_F(ElectronicNoise, OffIsWithoutAnyOfIt) {
  const Rows some = amplitudes(0, 1);
  settings.noise_dB = -120;
  const Rows lowest = amplitudes(0, 1);
  settings.effects.noise = false, settings.noise_dB = 0;
  const Rows none = amplitudes(0, 1);
  EXPECT_EQ(lowest, none) << "the lowest level is none";
  EXPECT_NE(some, none);
  EXPECT_LT(meanOf(amplitudes(-200, 1), 1), 2e-4) << "black";
}

}  // namespace
}  // namespace insonate
