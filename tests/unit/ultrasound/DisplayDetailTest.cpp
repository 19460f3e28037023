#include "DisplaySupport.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace insonate {
namespace {

using test::bareSettings;
using test::display;
using test::kGrayPerDb;

class EdgeEnhancement : public testing::TestWithParam<double> {
 protected:
  /// Level at a depth of the frame that `level_dB` gives by depth, in dB over unit speckle.
  double shown_dB(const std::function<double(double)>& level_dB, double depth_mm) const {
    const BModeImage image =
        display(probe, settings, test::frameOf(probe, settings, [&](double, double z) { return level_dB(z); }));
    return test::grayAt(image, 0, depth_mm) / kGrayPerDb - 20.5;
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
      EXPECT_NEAR(some.gray[at], 0.7 * none.gray[at] + 0.3 * all.gray[at], 2) << "each gray is rounded twice";
      different += std::abs(none.gray[at] - all.gray[at]) > 8;
    }
  EXPECT_GT(different, 1000);
}

/// Levels that vary along the face with so many cycles per mm, in pixels a quarter as wide as scanlines, d = 0.148 mm:
/// the cubic halfway between scanlines has h = (9 cos(pi f d) - cos(3 pi f d)) / 8 of the amplitude, and a straight
/// line between these keeps sinc^2(f d / 2), so that the power is ((1 + h) / 2 sinc^2(f d / 2))^2. A straight line
/// between scanlines alone would leave 0.86 and 0.55.
TEST(ScanConversion, KeepsLateralDetail) {
  const Probe probe = *loadProbe("linear");
  ImagingSettings settings = bareSettings(probe);
  settings.width = 1024, settings.height = 1078;
  settings.scanlines = 256;
  for (const auto& [perMm, kept] : {std::pair{1.0, 0.949}, {2.0, 0.691}}) {
    const BModeImage image = display(probe, settings, test::frameOf(probe, settings, [perMm = perMm](double x, double) {
                                       return 10 * std::sin(2 * std::numbers::pi * perMm * x);
                                     }));
    double sum = 0, square = 0;
    const int row = image.height / 2, first = 100, last = image.width - 100;
    for (int column = first; column < last; ++column) {
      const double gray = image.gray[std::size_t(row) * image.width + column];
      sum += gray, square += gray * gray;
    }
    const double count = last - first, power = square / count - sum / count * (sum / count);
    EXPECT_NEAR(power / (50 * kGrayPerDb * kGrayPerDb), kept, 0.03) << perMm << " per mm";
  }
}

}  // namespace
}  // namespace insonate
