#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/MMode.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace insonate {
namespace {

/// An image whose gray values are 4 for each mm of depth, and 1 for each mm to the right of -20 mm.
BModeImage ramp() {
  BModeImage image;
  image.width = 400, image.height = 420, image.pixel_mm = 0.1, image.left_mm = -20, image.top_mm = 0.05;
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      image.gray.push_back(static_cast<std::uint8_t>(std::lround(4 * (image.top_mm + row * 0.1) + column * 0.1)));
  return image;
}

TEST(MMode, ALineHasTheGrayValuesFromTheFaceToTheDepthOfTheImage) {
  const Probe probe = *loadProbe("linear");
  ImagingSettings settings = settingsFor(probe);
  settings.depth_mm = 40;
  std::array<std::uint8_t, 80> gray{};
  for (const double across : {0.25, 0.5, 0.75}) {
    lineOverTime(ramp(), probe, settings, across, gray);
    const double x_mm = (across - 0.5) * probe.width_mm;
    for (const int row : {1, 20, 40, 78}) EXPECT_NEAR(gray[row], 4 * (row + 0.5) * 0.5 + x_mm + 20, 1.2) << across;
  }
}

TEST(MMode, ASteeredLineCrossesTheImage) {
  const Probe probe = *loadProbe("linear");
  ImagingSettings settings = settingsFor(probe);
  settings.depth_mm = 30, settings.steering_deg = 20;
  std::array<std::uint8_t, 60> gray{};
  lineOverTime(ramp(), probe, settings, 0.5, gray);
  const BeamGrid grid(probe, settings);
  const double longest_mm = grid.range_mm(grid.samples() - 0.5);
  const double range_mm = longest_mm * 50.5 / 60, tilt = 20 * 3.14159265358979 / 180;
  EXPECT_NEAR(gray[50], 4 * range_mm * std::cos(tilt) + range_mm * std::sin(tilt) + 20, 1.5);
}

TEST(MMode, OutsideTheImageIsBlack) {
  const Probe probe = *loadProbe("linear");
  ImagingSettings settings = settingsFor(probe);
  settings.depth_mm = 80;
  std::array<std::uint8_t, 80> gray{};
  gray.fill(7);
  lineOverTime(ramp(), probe, settings, 0.5, gray);
  EXPECT_EQ(gray[79], 0);
  lineOverTime({}, probe, settings, 0.5, gray);
  EXPECT_EQ(gray[10], 0);
}

}  // namespace
}  // namespace insonate
