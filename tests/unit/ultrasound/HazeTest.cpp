#include "DisplaySupport.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace insonate {
namespace {

using test::bareSettings;
using test::display;
using test::frameOf;
using test::kGrayPerDb;

constexpr double kBlack_dB = -20.5;

class HazeTest : public testing::Test {
 protected:
  /// Mean level in dB over unit speckle of a piece of the image.
  double level_dB(const BModeImage& image, double left_mm, double right_mm, double depth_mm) const {
    double sum = 0;
    constexpr int kColumns = 40;
    for (int i = 0; i < kColumns; ++i)
      sum += test::grayAt(image, left_mm + (right_mm - left_mm) * (i + 0.5) / kColumns, depth_mm);
    return sum / kColumns / kGrayPerDb + kBlack_dB;
  }

  Probe probe = *loadProbe("linear");
  ImagingSettings settings = [this] {
    ImagingSettings s = bareSettings(probe);
    s.effects.clutter = true;
    s.gain_dB = 0;
    return s;
  }();
};

/// A wall by itself, so that nothing comes from beside or from half the depth.
TEST_F(HazeTest, FadesBelowTheNearWallWithinThreeMillimeters) {
  const auto lumen = [](double, double z) { return z > 8.5 && z < 10 ? 8.0 : -60.0; };
  const BModeImage image = display(probe, settings, frameOf(probe, settings, lumen));
  // Over some depths: what comes back repeatedly lies in ripples.
  const double under =
      (level_dB(image, -15, 15, 10.5) + level_dB(image, -15, 15, 10.8) + level_dB(image, -15, 15, 11.1)) / 3;
  EXPECT_GT(under, -12);
  EXPECT_LT(level_dB(image, -15, 15, 12), under - 3);
  EXPECT_LT(level_dB(image, -15, 15, 13.5), under - 6);
}

TEST_F(HazeTest, ComesFromTheSidesOfALumenAndLeavesItsMiddleDark) {
  const auto lumen = [](double x, double z) { return z > 16 && std::abs(x) < 6 ? -60.0 : 8.0; };
  const BModeImage image = display(probe, settings, frameOf(probe, settings, lumen));
  const double side = level_dB(image, -5.8, -5, 28), middle = level_dB(image, -1.5, 1.5, 28);
  EXPECT_GT(side, kBlack_dB + 3);
  EXPECT_GT(side, middle + 2);
}

TEST_F(HazeTest, EchoesComeAgainAtTwiceTheirDepth) {
  const auto layer = [](double, double z) { return z > 8 && z < 10 ? 8.0 : -60.0; };
  settings.gain_dB = 15;
  const BModeImage image = display(probe, settings, frameOf(probe, settings, layer));
  EXPECT_GT(level_dB(image, -10, 10, 18), level_dB(image, -10, 10, 26) + 4);
}

/// The survey of real necks: gray in the shadow of bone over that of the tissue above, 0.33 to 0.52.
TEST_F(HazeTest, BoneShinesOnIntoItsShadow) {
  const auto bone = [](double x, double z) {
    if (std::abs(x) > 5) return 0.0;
    return z < 15 ? 0.0 : z < 15.5 ? 32.0 : -60.0;
  };
  const BModeImage image = display(probe, settings, frameOf(probe, settings, bone));
  const auto share = [&](double depth_mm) {
    return (level_dB(image, -2, 2, depth_mm) - kBlack_dB) / (level_dB(image, -2, 2, 12) - kBlack_dB);
  };
  EXPECT_GT(share(18), 0.33);
  EXPECT_LT(share(18), 0.52);
  EXPECT_LT(share(26), share(18)) << "it fades";
}

TEST_F(HazeTest, HarmonicImagingHasLessOfIt) {
  const auto lumen = [](double, double z) { return z > 8.5 && z < 10 ? 8.0 : -60.0; };
  settings.gain_dB = 10;
  const double whole = level_dB(display(probe, settings, frameOf(probe, settings, lumen)), -15, 15, 10.8);
  settings.harmonic = true;
  EXPECT_NEAR(level_dB(display(probe, settings, frameOf(probe, settings, lumen)), -15, 15, 10.8), whole - 8, 0.5);
}

TEST_F(HazeTest, FasciaLeavesALumenBelowItDark) {
  const auto lumen = [](double, double z) { return z > 14 ? -60.0 : z > 13.7 ? 20.0 : -4.0; };
  const BModeImage image = display(probe, settings, frameOf(probe, settings, lumen));
  EXPECT_LT(level_dB(image, -10, 10, 19), -16);
}

TEST_F(HazeTest, DriftsFromPlaceToPlaceAndIsTheSameInAllFrames) {
  const auto lumen = [](double, double z) { return z > 10 ? -60.0 : 8.0; };
  const EnvelopeFrame frame = frameOf(probe, settings, lumen);
  const BModeImage image = display(probe, settings, frame);
  EXPECT_EQ(display(probe, settings, frame).gray, image.gray);
  double low = 99, high = -99;
  for (double x = -15; x < 15; x += 1) {
    const double here = level_dB(image, x, x + 0.5, 11);
    low = std::min(low, here), high = std::max(high, here);
  }
  EXPECT_GT(high - low, 3);
  EXPECT_LT(high - low, 9);
}

}  // namespace
}  // namespace insonate
