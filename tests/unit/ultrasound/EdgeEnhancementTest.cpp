#include "DisplaySupport.h"

#include <gtest/gtest.h>

#include <cmath>

namespace insonate {
namespace {

using test::bareSettings;
using test::display;

constexpr double kGreyPerDb = 255.0 / 60;

class EdgeEnhancement : public testing::TestWithParam<double> {
 protected:
  /// Level at a depth of the frame that `level_dB` gives by depth, in dB over unit speckle.
  double shown_dB(const std::function<double(double)>& level_dB, double depth_mm) const {
    const BModeImage image =
        display(probe, settings, test::frameOf(probe, settings, [&](double, double z) { return level_dB(z); }));
    return test::greyAt(image, 0, depth_mm) / kGreyPerDb - 20.5;
  }

  Probe probe = *loadProbe("linear");
  ImagingSettings settings = [this] {
    ImagingSettings s = bareSettings(probe);
    s.edgeEnhancement = GetParam();
    s.scanlines = s.width = 380, s.samples = s.height = 400;  // pixels of 0.1 mm are scanlines and samples
    return s;
  }();
};

/// 0.8 of what a level stands out from those half a pulse (0.13 mm, one sample) above and below: of a line of one
/// sample all of its 8 dB, of a step from 0 to 6 dB half.
TEST_P(EdgeEnhancement, LiftsALineAndOvershootsAtAStep) {
  const auto line = [](double z) { return std::abs(z - 20.05) < 0.04 ? 8.0 : 0.0; };
  EXPECT_NEAR(shown_dB(line, 20.05), 8 + GetParam() * 0.8 * 8, 0.5);
  EXPECT_NEAR(shown_dB(line, 20.15), -GetParam() * 0.8 * 4, 0.7) << "and darkens what is beside it";
  const auto step = [](double z) { return z < 20 ? 0.0 : 6.0; };
  EXPECT_NEAR(shown_dB(step, 20.05), 6 + GetParam() * 0.8 * 3, 0.5);
  EXPECT_NEAR(shown_dB(step, 19.95), -GetParam() * 0.8 * 3, 0.5);
}

TEST_P(EdgeEnhancement, LeavesEvenLevelsAndSlopesAlone) {
  for (const double depth_mm : {5.0, 20.0, 35.0})
    EXPECT_NEAR(shown_dB([](double z) { return z / 4; }, depth_mm), depth_mm / 4, 0.3);
}

TEST_P(EdgeEnhancement, IsLimited) {
  const auto line = [](double z) { return std::abs(z - 20.05) < 0.04 ? 20.0 : -18.0; };
  EXPECT_NEAR(shown_dB(line, 20.05), 20 + GetParam() * 0.8 * 10, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Strengths, EdgeEnhancement, testing::Values(0.0, 0.5, 1.0));

TEST(SpeckleReduction, IsTheShareOfTheSmoothedImage) {
  const Probe probe = *loadProbe("linear");
  ImagingSettings settings = bareSettings(probe);
  const EnvelopeFrame frame = test::frameOf(
      probe, settings, [](double x, double z) { return 6 * std::sin(12 * x) + 6 * std::sin(30 * z + x); });
  const auto shown = [&](double strength) {
    settings.speckleReduction = strength;
    return display(probe, settings, frame);
  };
  const BModeImage none = shown(0), some = shown(0.3), all = shown(1);
  int different = 0;
  for (int row = 10; row < none.height - 10; row += 7)
    for (int column = 10; column < none.width - 10; column += 7) {
      const std::size_t at = std::size_t(row) * none.width + column;
      EXPECT_NEAR(some.grey[at], 0.7 * none.grey[at] + 0.3 * all.grey[at], 2) << "each gray is rounded twice";
      different += std::abs(none.grey[at] - all.grey[at]) > 8;
    }
  EXPECT_GT(different, 1000);
}

}  // namespace
}  // namespace insonate
