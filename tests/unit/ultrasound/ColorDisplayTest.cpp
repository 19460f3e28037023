#include "support/Allocations.h"

#include <insonate/ultrasound/ColorDisplay.h>
#include <insonate/ultrasound/Display.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace insonate {
namespace {

class ColorDisplayTest : public testing::Test {
 protected:
  ColorDisplayTest() {
    settings_.effects.noise = false;
    Display(probe_, settings_).process({}, gray_);
  }
  /// Every sample volume has this power and velocity.
  ColorFrame frameOf(double power, double toward_mmps) const {
    ColorFrame frame;
    frame.resize(sizeOf().first, sizeOf().second);
    const double phase = std::numbers::pi * toward_mmps / nyquistVelocity_mmps(color_);
    for (std::size_t i = 0; i < frame.power.size(); ++i) {
      frame.power[i] = float(power);
      frame.lagOneRe[i] = float(power * std::cos(phase)), frame.lagOneIm[i] = float(power * std::sin(phase));
    }
    return frame;
  }
  std::pair<int, int> sizeOf() const {
    const std::size_t all = ColorDisplay(probe_, settings_, color_).velocities_mmps().size();
    const int gates = std::max(4, int(std::lround((color_.far_mm - color_.near_mm) / 0.4)));
    return {int(all) / gates, gates};
  }
  static Rgb middle(const ColorImage& image) {
    const std::uint8_t* p = image.rgba.data() + (std::size_t(image.height / 2) * image.width + image.width / 2) * 4;
    return {p[0], p[1], p[2]};
  }
  static double coloredShare(const ColorImage& image) {
    double colored = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
      colored += image.rgba[i + 3] == 255 && image.rgba[i] != image.rgba[i + 2];  // without the gray outline
    return colored / (double(image.width) * image.height);
  }
  ColorImage imageOf(const ColorFrame& frame, std::uint32_t seed = 0) {
    ColorImage image;
    ColorDisplay(probe_, settings_, color_).process(frame, gray_, image, seed);
    return image;
  }

  Probe probe_ = *loadProbe("linear");
  ImagingSettings settings_ = settingsFor(probe_);
  ColorSettings color_ = colorSettingsFor(probe_, settings_);
  BModeImage gray_;
};

TEST_F(ColorDisplayTest, FlowTowardTheProbeIsRedAndInvertedIsBlue) {
  const double half = 0.5 * nyquistVelocity_mmps(color_);
  const Rgb toward = middle(imageOf(frameOf(100, half))), away = middle(imageOf(frameOf(100, -half)));
  EXPECT_GT(toward[0], toward[2] + 100);
  EXPECT_GT(away[2], away[0] + 100);
  color_.invert = true;
  EXPECT_EQ(middle(imageOf(frameOf(100, -half)))[2], velocityColor(-0.5, true)[2]);
  EXPECT_GT(middle(imageOf(frameOf(100, -half)))[0], 150);
}

TEST_F(ColorDisplayTest, TheBoxIsFilledAndItsSizeIsThatOfTheSettings) {
  const ColorImage image = imageOf(frameOf(100, 50));
  EXPECT_GT(coloredShare(image), 0.97);
  EXPECT_NEAR(image.height * gray_.pixel_mm, color_.far_mm - color_.near_mm, 0.2);
  EXPECT_NEAR(image.width * gray_.pixel_mm, (color_.right - color_.left) * probe_.width_mm, 0.6);
  EXPECT_EQ(image.nyquist_mmps, nyquistVelocity_mmps(color_));
}

TEST_F(ColorDisplayTest, GainAndPriorityDecideWhereColorIsShown) {
  EXPECT_EQ(coloredShare(imageOf(frameOf(0.5, 50))), 0);
  color_.gain_dB = 4;
  EXPECT_GT(coloredShare(imageOf(frameOf(0.5, 50))), 0.97);
  std::ranges::fill(gray_.gray, std::uint8_t{200});
  EXPECT_EQ(coloredShare(imageOf(frameOf(0.5, 50))), 0);
  color_.priority = 1;
  EXPECT_GT(coloredShare(imageOf(frameOf(0.5, 50))), 0.97);
}

TEST_F(ColorDisplayTest, NoiseAppearsOnlyWithHighGain) {
  settings_.effects.noise = true;
  EXPECT_LT(coloredShare(imageOf(frameOf(0, 0))), 0.001);
  color_.gain_dB = 10;
  const ColorImage noisy = imageOf(frameOf(0, 0), 1);
  EXPECT_GT(coloredShare(noisy), 0.2);
  EXPECT_EQ(imageOf(frameOf(0, 0), 1).rgba, noisy.rgba);
  EXPECT_NE(imageOf(frameOf(0, 0), 2).rgba, noisy.rgba);
}

TEST_F(ColorDisplayTest, EstimatesScatterAroundTheVelocity) {
  settings_.effects.noise = true;
  const double velocity = 0.4 * nyquistVelocity_mmps(color_);
  ColorDisplay display(probe_, settings_, color_);
  ColorImage image;
  display.process(frameOf(20, velocity), gray_, image, 3);
  double sum = 0, squares = 0, count = 0;
  for (const float v : display.velocities_mmps())
    if (std::isfinite(v)) sum += v, squares += double(v) * v, ++count;
  const double mean = sum / count, sd = std::sqrt(squares / count - mean * mean);
  EXPECT_NEAR(mean, velocity, 0.01 * velocity);
  EXPECT_GT(sd, 0.005 * velocity);
  EXPECT_LT(sd, 0.1 * velocity);
}

TEST_F(ColorDisplayTest, PersistenceKeepsAPartOfThePreviousImage) {
  color_.persistence = 0.5;
  ColorDisplay display(probe_, settings_, color_);
  ColorImage image;
  display.process(frameOf(100, 50), gray_, image);
  display.process(frameOf(0, 0), gray_, image);
  EXPECT_GT(coloredShare(image), 0.97);
  display.reset();
  display.process(frameOf(0, 0), gray_, image);
  EXPECT_EQ(coloredShare(image), 0);
}

TEST_F(ColorDisplayTest, PowerHasItsOwnColors) {
  color_.mode = ColorMode::Power;
  const Rgb weak = middle(imageOf(frameOf(2, 50))), strong = middle(imageOf(frameOf(900, -50)));
  EXPECT_GT(strong[1], weak[1] + 80);
}

TEST_F(ColorDisplayTest, AllocatesNothingAfterTheFirstFrame) {
  ColorDisplay display(probe_, settings_, color_);
  ColorImage image;
  const ColorFrame frame = frameOf(100, 50);
  display.process(frame, gray_, image);
  const long before = test::allocations();
  display.process(frame, gray_, image);
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace insonate
