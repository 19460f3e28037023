#include "DisplaySupport.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace insonate {
namespace {

using test::bareSettings;
using test::display;
using test::uniformFrame;

constexpr double kGreyPerDb = 255.0 / 60;

class FaceEchoes : public testing::Test {
 protected:
  /// Mean level in dB over unit speckle of a strip 1 mm wide.
  double level_dB(const BModeImage& image, double lateral_mm, double depth_mm) const {
    double sum = 0;
    for (int i = -5; i <= 5; ++i) sum += test::greyAt(image, lateral_mm + 0.1 * i, depth_mm);
    return sum / 11 / kGreyPerDb - 20.5;
  }

  Probe probe = *loadProbe("linear");
  ImagingSettings settings = [this] {
    ImagingSettings s = bareSettings(probe);
    s.effects.nearField = true;
    s.ringing_dB = 30;
    return s;
  }();
};

TEST_F(FaceEchoes, RingingStartsAtItsLevelAndIsOverAfterTwoMillimeters) {
  const BModeImage image = display(probe, settings, uniformFrame(probe, settings, -200));
  EXPECT_NEAR(level_dB(image, 0, 0.05), 30, 4);
  EXPECT_GT(level_dB(image, 0, 0.75), 10) << "an echo of the lens";
  EXPECT_LT(level_dB(image, 0, 0.75), 22);
  EXPECT_LT(level_dB(image, 0, 1.1), level_dB(image, 0, 0.75) - 6) << "between two of them";
  EXPECT_LT(level_dB(image, 0, 3.2), -20);
  settings.ringing_dB = 10;
  const BModeImage soft = display(probe, settings, uniformFrame(probe, settings, -200));
  EXPECT_NEAR(level_dB(image, 0, 0.75) - level_dB(soft, 0, 0.75), 20, 1);
}

TEST_F(FaceEchoes, RingingIsTheSameInAllFramesAndDiffersBetweenElements) {
  Display live(probe, settings);
  BModeImage first, second;
  const EnvelopeFrame silent = uniformFrame(probe, settings, -200);
  live.process(silent, first, 1);
  live.process(silent, second, 2);
  EXPECT_EQ(first.grey, second.grey);
  int low = 255, high = 0;
  for (double x = -18; x <= 18; x += 0.5) {
    const int grey = test::greyAt(first, x, 0.4);
    low = std::min(low, grey), high = std::max(high, grey);
  }
  EXPECT_GT(high - low, 0.8 * kGreyPerDb);
  EXPECT_LT(high - low, 2.5 * kGreyPerDb);
}

TEST_F(FaceEchoes, WhereTheSkinDoesNotTouchLittleComesBackAndTheLensRingsOn) {
  settings.poorContactLeft_mm = 6;
  settings.poorContactRight_mm = 2;
  const BModeImage image = display(probe, settings, uniformFrame(probe, settings, 10));
  for (const double depth_mm : {15.0, 35.0}) {
    EXPECT_NEAR(level_dB(image, 0, depth_mm), 10, 0.2);
    EXPECT_NEAR(level_dB(image, -17, depth_mm), 10 - 28, 1) << "the left of the image";
    EXPECT_LT(level_dB(image, -15, depth_mm), 8) << "contact returns smoothly";
    EXPECT_NEAR(level_dB(image, -12.4, depth_mm), 10, 0.2);
    EXPECT_NEAR(level_dB(image, 16.4, depth_mm), 10, 0.2);
    EXPECT_LT(level_dB(image, 18.5, depth_mm), 0);
  }
  EXPECT_GT(level_dB(image, -17, 3), level_dB(image, -17, 15) + 6) << "echoes of the lens";
}

TEST_F(FaceEchoes, AllScanlinesOfAPhasedArrayTouch) {
  probe = *loadProbe("phased");
  settings = bareSettings(probe);
  const BModeImage without = display(probe, settings, uniformFrame(probe, settings, 10));
  settings.effects.nearField = true;
  settings.poorContactLeft_mm = settings.poorContactRight_mm = 30;
  const BModeImage with = display(probe, settings, uniformFrame(probe, settings, 10));
  for (const double lateral_mm : {-60.0, 0.0, 60.0})
    EXPECT_EQ(test::greyAt(with, lateral_mm, 100), test::greyAt(without, lateral_mm, 100));
}

TEST_F(FaceEchoes, OffIsWithoutAnyOfIt) {
  settings.effects.nearField = false;
  settings.poorContactLeft_mm = 6;
  const BModeImage image = display(probe, settings, uniformFrame(probe, settings, -200));
  EXPECT_EQ(*std::max_element(image.grey.begin(), image.grey.end()), 0);
  EXPECT_NEAR(level_dB(display(probe, settings, uniformFrame(probe, settings, 10)), -17, 20), 10, 0.2);
}

}  // namespace
}  // namespace insonate
