#include <insonate/ultrasound/Display.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate {
namespace {

/// Signed room to the nearest edge of the analytic shape, mm; positive inside.
double room_mm(const Probe& probe, const ImagingSettings& settings, double x, double z) {
  if (probe.shape == ProbeShape::Linear) return std::min({probe.width_mm / 2 - std::abs(x), z, settings.depth_mm - z});
  const double half = probe.fovAngle_deg / 2 * std::numbers::pi / 180;
  const double fromApex = z + probe.faceRadius_mm, r = std::sqrt(x * x + fromApex * fromApex);
  const double toSide = fromApex * std::sin(half) - std::abs(x) * std::cos(half);
  return std::min({toSide, r - probe.faceRadius_mm, probe.faceRadius_mm + settings.depth_mm - r});
}

struct Case {
  const char* probe;
  int width, height;
  double depth_mm;
};

class MaskOf : public testing::TestWithParam<Case> {
 protected:
  Probe probe = *loadProbe(GetParam().probe);
  ImagingSettings settings = [this] {
    ImagingSettings s = settingsFor(probe);
    s.width = GetParam().width, s.height = GetParam().height, s.depth_mm = GetParam().depth_mm;
    return s;
  }();
  BModeImage image = [this] {
    EnvelopeFrame loud;
    loud.resize(settings.scanlines, settings.samples, 1);
    std::fill(loud.amplitude.begin(), loud.amplitude.end(), 1e9F);
    BModeImage picture;
    Display(probe, settings).process(loud, picture);
    return picture;
  }();
};

TEST_P(MaskOf, IsTheAnalyticShapeToThePixel) {
  const auto mask = fieldOfViewMask(probe, settings);
  ASSERT_EQ(mask.size(), std::size_t(settings.width) * settings.height);
  int wrong = 0, inside = 0;
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column) {
      const double room =
          room_mm(probe, settings, image.left_mm + column * image.pixel_mm, image.top_mm + row * image.pixel_mm);
      const bool marked = mask[std::size_t(row) * image.width + column] == 1;
      inside += marked;
      wrong += std::abs(room) > 1e-9 && marked != (room > 0);
    }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(inside, 1000);
}

TEST_P(MaskOf, IsWhereThePictureIsLit) {
  const auto mask = fieldOfViewMask(probe, settings);
  int differing = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) differing += (mask[i] == 1) != (image.gray[i] > 0);
  EXPECT_EQ(differing, 0);
}

TEST_P(MaskOf, FillsThePictureAndIsCenterd) {
  const auto mask = fieldOfViewMask(probe, settings);
  int left = image.width, right = -1, top = image.height, bottom = -1;
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      if (mask[std::size_t(row) * image.width + column]) {
        left = std::min(left, column), right = std::max(right, column);
        top = std::min(top, row), bottom = std::max(bottom, row);
      }
  EXPECT_LE(std::abs(left - (image.width - 1 - right)), 1);
  EXPECT_LE(std::abs(top - (image.height - 1 - bottom)), 1);
  EXPECT_LE(std::min(left, top), 1) << "one direction is filled";
}

INSTANTIATE_TEST_SUITE_P(Probes, MaskOf,
                         testing::Values(Case{"linear", 820, 616, 40}, Case{"linear", 400, 901, 60},
                                         Case{"curvilinear", 820, 616, 120}, Case{"curvilinear", 301, 640, 50},
                                         Case{"phased", 820, 616, 150}, Case{"phased", 640, 480, 60}),
                         [](const auto& parameter) {
                           const Case& c = parameter.param;
                           return std::string(c.probe) + "_" + std::to_string(c.width) + "x" + std::to_string(c.height);
                         });

}  // namespace
}  // namespace insonate
