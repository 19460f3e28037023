#include "DisplaySupport.h"

#include <insonate/ultrasound/GrayMaps.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace insonate {
namespace {

using test::bareSettings;
using test::display;
using test::frameOf;
using test::grayAt;
using test::kGrayPerDb;
using test::uniformFrame;

int brightest(const BModeImage& image) {
  return *std::max_element(image.gray.begin(), image.gray.end());
}

class DisplayTest : public testing::Test {
 protected:
  Probe probe = *loadProbe("linear");
  ImagingSettings settings = bareSettings(probe);

  int grayOfLevel(double level_dB) {
    return grayAt(display(probe, settings, uniformFrame(probe, settings, level_dB)), 0, 20);
  }
};

TEST_F(DisplayTest, TenTimesTheAmplitudeIsTwentyDecibels) {
  EXPECT_NEAR(grayOfLevel(10) - grayOfLevel(-10), 20 * kGrayPerDb, 1);
}

TEST_F(DisplayTest, WhiteIsWhereItShouldBe) {
  EXPECT_NEAR(grayOfLevel(0), (60 - 39.5) * kGrayPerDb, 0.6);
  EXPECT_EQ(grayOfLevel(39.6), 255);
  EXPECT_EQ(grayOfLevel(45), 255);
  EXPECT_EQ(grayOfLevel(-20.5), 0);
  for (double level = -20; level < 39; level += 2.9) EXPECT_NEAR(grayOfLevel(level), (level + 20.5) * kGrayPerDb, 0.6);
}

TEST_F(DisplayTest, DynamicRangeKeepsWhite) {
  settings.dynamicRange_dB = 80;
  EXPECT_NEAR(grayOfLevel(0), (80 - 39.5) * 255 / 80, 0.6);
  EXPECT_EQ(grayOfLevel(39.6), 255);
}

TEST_F(DisplayTest, GainAddsDecibels) {
  const int before = grayOfLevel(0);
  settings.gain_dB = 6;
  EXPECT_NEAR(grayOfLevel(0) - before, 6 * kGrayPerDb, 1);
  settings.gain_dB = -6;
  EXPECT_NEAR(grayOfLevel(0) - before, -6 * kGrayPerDb, 1);
}

TEST_F(DisplayTest, SlidersActAtTheirDepthAndSmoothlyBetween) {
  const EnvelopeFrame frame = uniformFrame(probe, settings, 0);
  const BModeImage flat = display(probe, settings, frame);
  settings.tgc_dB[3] = 10;
  const BModeImage lifted = display(probe, settings, frame);
  const auto change = [&](double depth_mm) { return grayAt(lifted, 0, depth_mm) - grayAt(flat, 0, depth_mm); };
  EXPECT_NEAR(change(3.5 * 5), 10 * kGrayPerDb, 1);
  EXPECT_NEAR(change(3 * 5), 5 * kGrayPerDb, 1.5) << "half way between two sliders";
  for (const int other : {0, 1, 2, 4, 5, 6, 7}) EXPECT_EQ(change((other + 0.5) * 5), 0) << other;
  for (double depth_mm = 0.1; depth_mm < 39.8; depth_mm += 0.1)
    EXPECT_LE(std::abs(change(depth_mm + 0.1) - change(depth_mm)), 3);
}

TEST_F(DisplayTest, BuiltInCompensationLevelsTypicalTissue) {
  settings.effects.attenuation = true;
  const double slope_dBpmm = kTgc_dBpcmMHz * settings.frequency_MHz / 10;
  const BModeImage image =
      display(probe, settings, frameOf(probe, settings, [=](double, double z) { return -slope_dBpmm * z; }));
  for (const double depth_mm : {1.0, 10.0, 25.0, 39.0}) EXPECT_NEAR(grayAt(image, 0, depth_mm), 87, 1);
}

TEST_F(DisplayTest, EndsOfTheArrayAreDarkerBelowTheSkin) {
  settings.effects.attenuation = true;
  const double slope_dBpmm = kTgc_dBpcmMHz * settings.frequency_MHz / 10;
  const EnvelopeFrame level = frameOf(probe, settings, [=](double, double z) { return -slope_dBpmm * z; });
  const BModeImage image = display(probe, settings, level);
  EXPECT_NEAR(grayAt(image, 18.8, 20) - grayAt(image, 0, 20), -4.2 * kGrayPerDb, 0.6 * kGrayPerDb);
  EXPECT_NEAR(grayAt(image, -18.8, 20), grayAt(image, 18.8, 20), 1);
  EXPECT_NEAR(grayAt(image, 18.8, 3), grayAt(image, 0, 3), 1);
  EXPECT_NEAR(grayAt(image, 13, 20), grayAt(image, 0, 20), 1);
}

TEST_F(DisplayTest, BrightPlacesNearTheSkinLeaveStreaks) {
  settings.effects.attenuation = true;
  const double slope_dBpmm = kTgc_dBpcmMHz * settings.frequency_MHz / 10;
  const auto streak = [&](double bright_mm) {
    const BModeImage image = display(probe, settings, frameOf(probe, settings, [=](double x, double z) {
                                       const bool bright = std::abs(x) < 1 && std::abs(z - bright_mm) < 1;
                                       return (bright ? 7 : 0) - slope_dBpmm * z;
                                     }));
    return (grayAt(image, 0, 30) - grayAt(image, 10, 30)) / kGrayPerDb;
  };
  EXPECT_LT(streak(4), -0.5);
  EXPECT_GT(streak(4), -2.1);
  EXPECT_NEAR(streak(15), 0, 0.3) << "too deep";
  settings.effects.attenuation = false;
  EXPECT_NEAR(streak(4), 0, 0.3) << "nothing is lost without attenuation";
}

TEST_F(DisplayTest, LooksAreAveragedAsMagnitudes) {
  settings.looks = 3;
  EnvelopeFrame frame = uniformFrame(probe, settings, 0);
  std::fill_n(frame.look(1), 256 * 1000, 2.0F);
  std::fill_n(frame.look(2), 256 * 1000, 6.0F);
  EXPECT_NEAR(grayAt(display(probe, settings, frame), 0, 20), (20 * std::log10(3) + 20.5) * kGrayPerDb, 0.6);
}

TEST_F(DisplayTest, PersistenceMixesWithThePreviousPicture) {
  settings.persistence = 0.75;
  Display live(probe, settings);
  BModeImage image;
  const auto show = [&](double level_dB) {
    live.process(uniformFrame(probe, settings, level_dB), image);
    return grayAt(image, 0, 20);
  };
  const int bright = show(20);
  EXPECT_NEAR(bright, 40.5 * kGrayPerDb, 0.6) << "nothing to mix with yet";
  EXPECT_NEAR(show(0), (20.5 + 0.75 * 20) * kGrayPerDb, 0.6);
  EXPECT_NEAR(show(0), (20.5 + 0.75 * 0.75 * 20) * kGrayPerDb, 0.6);
  live.reset();
  EXPECT_NEAR(show(0), 20.5 * kGrayPerDb, 0.6);
}

/// The gray of a level half way between black and white.
struct MapCase {
  GrayMap map;
  const char* name;
  int middle;
};
const MapCase kMaps[]{{GrayMap::Linear, "linear", 128},     {GrayMap::Soft, "soft", 102},
                      {GrayMap::Contrast, "contrast", 116}, {GrayMap::Bright, "bright", 143},
                      {GrayMap::Dark, "dark", 77},          {GrayMap::Flat, "flat", 134}};

TEST_F(DisplayTest, EachGrayMapRisesFromBlackToWhiteThroughItsMiddle) {
  ASSERT_EQ(grayMaps().size(), std::size(kMaps));
  for (const auto& [map, name, middle] : kMaps) {
    EXPECT_EQ(curveOf(map).map, map);
    EXPECT_EQ(curveOf(map).name, name);
    settings.grayMap = map;
    EXPECT_NEAR(grayOfLevel(39.5 - 30), middle, 1) << name;
    EXPECT_EQ(grayOfLevel(-20.6), 0) << name;
    EXPECT_EQ(grayOfLevel(39.6), 255) << name;
    for (int last = -1, step = 0; step <= 60; step += 2) {
      const int gray = grayOfLevel(step - 20.5);
      EXPECT_GT(gray, last) << name << " at " << step << " dB over black";
      last = gray;
    }
  }
}

TEST_F(DisplayTest, LateralGainActsOnItsScanlinesAtAllDepths) {
  const EnvelopeFrame frame = uniformFrame(probe, settings, 0);
  const BModeImage flat = display(probe, settings, frame);
  settings.lateralGain_dB[6] = -8;
  const BModeImage image = display(probe, settings, frame);
  const auto change = [&](double lateral_mm, double depth_mm) {
    return (grayAt(image, lateral_mm, depth_mm) - grayAt(flat, lateral_mm, depth_mm)) / kGrayPerDb;
  };
  const double middle_mm = (6.5 / 8 - 0.5) * probe.width_mm;
  for (const double depth_mm : {1.0, 20.0, 39.0}) {
    EXPECT_NEAR(change(middle_mm, depth_mm), -8, 0.3);
    EXPECT_NEAR(change(middle_mm - probe.width_mm / 16, depth_mm), -4, 0.4) << "half way to the next";
    EXPECT_NEAR(change(-middle_mm, depth_mm), 0, 0.1);
  }
}

TEST_F(DisplayTest, HazeLiftsALumenNearItsWallMost) {
  const auto lumen = [](double x, double z) { return std::hypot(x, z - 20) < 5 ? -60.0 : 0.0; };
  const EnvelopeFrame frame = frameOf(probe, settings, lumen);
  const BModeImage clear = display(probe, settings, frame);
  EXPECT_EQ(grayAt(clear, 0, 20), 0);
  settings.effects.clutter = true;
  const BModeImage hazy = display(probe, settings, frame);
  const int near = grayAt(hazy, 0, 15.8), far = grayAt(hazy, 0, 24);
  EXPECT_GT(near, far);
  EXPECT_GT(near, 5);
  EXPECT_LT(near, 50);
  EXPECT_LT(grayAt(hazy, 12, 20), 1.05 * grayAt(clear, 12, 20)) << "haze is small beside tissue";
}

TEST_F(DisplayTest, SilenceIsBlack) {
  for (const bool everything : {false, true}) {
    ImagingSettings chosen = everything ? settingsFor(probe) : settings;
    chosen.effects.noise = chosen.effects.nearField = false;
    EnvelopeFrame frame;
    frame.resize(chosen.scanlines, chosen.samples, chosen.looks);
    EXPECT_EQ(brightest(display(probe, chosen, frame)), 0);
  }
}

TEST_F(DisplayTest, UnusableAmplitudesAreBlackOrWhite) {
  settings.effects.clutter = true;
  const auto grayFor = [&](float amplitude) {
    EnvelopeFrame frame = uniformFrame(probe, settings, 0);
    std::fill(frame.amplitude.begin(), frame.amplitude.end(), amplitude);
    return grayAt(display(probe, settings, frame), 0, 20);
  };
  const float infinity = std::numeric_limits<float>::infinity();
  for (const double strength : {0.0, 0.5, 1.0}) {
    settings.speckleReduction = settings.edgeEnhancement = strength;
    EXPECT_EQ(grayFor(std::numeric_limits<float>::quiet_NaN()), 0);
    EXPECT_EQ(grayFor(-1), 0);
    EXPECT_EQ(grayFor(-infinity), 0);
    EXPECT_EQ(grayFor(std::numeric_limits<float>::denorm_min()), 0);
    EXPECT_EQ(grayFor(infinity), 255);
    EXPECT_EQ(grayFor(std::numeric_limits<float>::max()), 255);
  }
}

TEST_F(DisplayTest, OneBadSampleStaysLocal) {
  settings = settingsFor(probe);
  settings.effects.attenuation = settings.effects.noise = settings.effects.nearField = false;
  settings.speckleReduction = 1;
  settings.persistence = 0.5;
  EnvelopeFrame frame = uniformFrame(probe, settings, 0);
  const BModeImage clean = display(probe, settings, frame);
  frame.look(0)[500 * 256 + 128] = std::numeric_limits<float>::quiet_NaN();
  frame.look(1)[600 * 256 + 40] = std::numeric_limits<float>::infinity();
  const BModeImage dirty = display(probe, settings, frame);
  for (const double depth_mm : {5.0, 15.0, 35.0})
    for (const double lateral_mm : {-15.0, 8.0, 16.0})
      EXPECT_NEAR(grayAt(dirty, lateral_mm, depth_mm), grayAt(clean, lateral_mm, depth_mm), 2);
}

TEST_F(DisplayTest, FrameOfAnotherSizeIsBlack) {
  EnvelopeFrame frame = uniformFrame(probe, settings, 30);
  frame.looks = 2;
  EXPECT_EQ(brightest(display(probe, settings, frame)), 0);
  frame.resize(100, 1000, 1);
  EXPECT_EQ(brightest(display(probe, settings, frame)), 0);
  EXPECT_EQ(brightest(display(probe, settings, EnvelopeFrame{})), 0);
}

TEST_F(DisplayTest, ExtremeSizesWork) {
  for (const char* name : {"linear", "curvilinear", "phased"})
    for (const auto& [lines, samples, size] : {std::tuple{16, 64, 64}, {17, 65, 129}, {1024, 4096, 300}}) {
      const Probe any = *loadProbe(name);
      settings = settingsFor(any);
      settings.scanlines = lines, settings.samples = samples, settings.width = size, settings.height = size;
      settings.effects.attenuation = settings.effects.nearField = settings.effects.clutter = false;
      settings.looks = 1;
      ASSERT_TRUE(validate(settings, any));
      const BModeImage image = display(any, settings, uniformFrame(any, settings, 0));
      const auto inside = fieldOfViewMask(any, settings);
      for (std::size_t i = 0; i < inside.size(); ++i) {
        if (!inside[i]) continue;
        ASSERT_NEAR(image.gray[i], 60, 4) << name << " " << lines << " at " << i;
      }
    }
}

/// A bright spot must appear where it is, whatever the shape of the scan.
TEST_F(DisplayTest, PointsLandWhereTheyAre) {
  struct Place {
    const char* probe;
    double lateral_mm, axial_mm, radius_mm;
  };
  for (const auto& [name, x0, z0, radius] :
       {Place{"linear", 7.3, 12.4, 1.5}, Place{"linear", -15.1, 33.3, 1.5}, Place{"curvilinear", -20.2, 60.7, 4},
        Place{"curvilinear", 31.4, 40.1, 4}, Place{"phased", 30.3, 70.9, 5}, Place{"phased", -50.7, 90.2, 6}}) {
    const Probe any = *loadProbe(name);
    settings = bareSettings(any);
    const auto spot = [x = x0, z = z0, r = radius](double lateral_mm, double axial_mm) {
      return 39 - 59 * std::pow(std::hypot(lateral_mm - x, axial_mm - z) / r, 2);
    };
    const BModeImage image = display(any, settings, frameOf(any, settings, spot));
    double sum = 0, x = 0, z = 0;
    for (int row = 0; row < image.height; ++row)
      for (int column = 0; column < image.width; ++column) {
        const double gray = image.gray[std::size_t(row) * image.width + column];
        sum += gray;
        x += gray * (image.left_mm + column * image.pixel_mm), z += gray * (image.top_mm + row * image.pixel_mm);
      }
    ASSERT_GT(sum, 0);
    EXPECT_NEAR(x / sum, x0, 0.1) << name;
    EXPECT_NEAR(z / sum, z0, 0.1) << name;
  }
}

}  // namespace
}  // namespace insonate
