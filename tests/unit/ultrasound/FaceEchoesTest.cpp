#include "DisplaySupport.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace insonate {
namespace {

using test::bareSettings;
using test::display;
using test::kGrayPerDb;
using test::uniformFrame;

class FaceEchoes : public testing::Test {
 protected:
  /// Mean level in dB over unit speckle of a strip 1 mm wide.
  double level_dB(const BModeImage& image, double lateral_mm, double depth_mm) const {
    double sum = 0;
    for (int i = -5; i <= 5; ++i) sum += test::grayAt(image, lateral_mm + 0.1 * i, depth_mm);
    return sum / 11 / kGrayPerDb - 20.5;
  }

  /// Level of tissue at 10 dB where the whole face touches.
  double touched_dB(double depth_mm) const {
    ImagingSettings touching = settings;
    touching.poorContactLeft_mm = touching.poorContactRight_mm = 0;
    return level_dB(display(probe, touching, uniformFrame(probe, touching, 10)), 0, depth_mm);
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

/// At 1 mm four elements of 0.3 mm receive, at 6 mm half of what is full, and 0.6 of what they lack is seen.
TEST_F(FaceEchoes, NearTheFaceFewElementsReceive) {
  settings.ringing_dB = -20;
  probe.pitch_mm = 0.3, probe.receiveFNumber = 1.5;
  EXPECT_NEAR(touched_dB(20), 10, 0.5);
  EXPECT_NEAR(touched_dB(6), 10 - 0.6 * 6.02, 0.7);
  EXPECT_NEAR(touched_dB(1.2), 10 - 0.6 * 20 * std::log10(8 / 1.2), 1);
  settings.effects.nearField = false;
  EXPECT_NEAR(touched_dB(1.2), 10, 0.5);
}

TEST_F(FaceEchoes, RingingIsTheSameInAllFramesAndDiffersBetweenElements) {
  Display live(probe, settings);
  BModeImage first, second;
  const EnvelopeFrame silent = uniformFrame(probe, settings, -200);
  live.process(silent, first, 1);
  live.process(silent, second, 2);
  EXPECT_EQ(first.gray, second.gray);
  int low = 255, high = 0;
  for (double x = -18; x <= 18; x += 0.5) {
    const int gray = test::grayAt(first, x, 0.4);
    low = std::min(low, gray), high = std::max(high, gray);
  }
  EXPECT_GT(high - low, 0.8 * kGrayPerDb);
  EXPECT_LT(high - low, 2.5 * kGrayPerDb);
}

/// Mean level of what a lifted end leaves of tissue at 10 dB.
TEST_F(FaceEchoes, WhereTheSkinDoesNotTouchLittleComesBack) {
  settings.poorContactLeft_mm = 8;
  settings.poorContactRight_mm = 3;
  const BModeImage image = display(probe, settings, uniformFrame(probe, settings, 10));
  EXPECT_LT(level_dB(image, -18, 6), touched_dB(6) - 26) << "the left of the image";
  for (const double depth_mm : {6.0, 15.0, 35.0}) {
    const double where_dB = touched_dB(depth_mm);
    EXPECT_NEAR(level_dB(image, 0, depth_mm), where_dB, 0.5) << "the deepest aperture reaches the strip";
    EXPECT_LT(level_dB(image, -18, depth_mm), where_dB - 10) << depth_mm;
    EXPECT_LT(level_dB(image, 18, depth_mm), level_dB(image, 12, depth_mm)) << "a thin film of gel";
  }
}

/// Apertures grow with the depth: deep down, elements that touch see past those that do not.
TEST_F(FaceEchoes, AStripOfPoorContactBlursAndNarrowsWithDepth) {
  settings.poorContactLeft_mm = 8;
  const BModeImage image = display(probe, settings, uniformFrame(probe, settings, 10));
  const auto from_mm = [&](double level, double depth_mm) {
    const double lack_dB = touched_dB(depth_mm) - 10;
    double x = -18.5;
    while (x < 0 && level_dB(image, x, depth_mm) < level + lack_dB) x += 0.1;
    return x;
  };
  const auto border_mm = [&](double depth_mm) { return from_mm(7, depth_mm) - from_mm(-5, depth_mm); };
  EXPECT_GT(border_mm(6), 1.2) << "no step";
  EXPECT_GT(border_mm(30), 1.5 * border_mm(6));
  EXPECT_LT(from_mm(-5, 30), from_mm(-5, 6) - 0.5) << "narrower below";
  EXPECT_LT(from_mm(9.5, 30), 2) << "the middle of the face has all of its aperture";
}

TEST_F(FaceEchoes, TheLensRingsOnWhereItIsLiftedButOnlyNearTheFace) {
  settings.poorContactLeft_mm = 10;
  const BModeImage image = display(probe, settings, uniformFrame(probe, settings, -200));
  EXPECT_GT(level_dB(image, -18, 2.25), level_dB(image, 0, 2.25) + 5);
  EXPECT_LT(level_dB(image, -18, 5), -20);
}

TEST_F(FaceEchoes, AllScanlinesOfAPhasedArrayTouch) {
  probe = *loadProbe("phased");
  settings = bareSettings(probe);
  const BModeImage without = display(probe, settings, uniformFrame(probe, settings, 10));
  settings.effects.nearField = true;
  settings.poorContactLeft_mm = settings.poorContactRight_mm = 30;
  const BModeImage with = display(probe, settings, uniformFrame(probe, settings, 10));
  for (const double lateral_mm : {-60.0, 0.0, 60.0})
    EXPECT_EQ(test::grayAt(with, lateral_mm, 100), test::grayAt(without, lateral_mm, 100));
}

TEST_F(FaceEchoes, OffIsWithoutAnyOfIt) {
  settings.effects.nearField = false;
  settings.poorContactLeft_mm = 6;
  const BModeImage image = display(probe, settings, uniformFrame(probe, settings, -200));
  EXPECT_EQ(*std::max_element(image.gray.begin(), image.gray.end()), 0);
  EXPECT_NEAR(level_dB(display(probe, settings, uniformFrame(probe, settings, 10)), -17, 20), 10, 0.2);
}

}  // namespace
}  // namespace insonate
