#include <insonate/ultrasound/BeamGrid.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace insonate {
namespace {

class BeamGridOf : public testing::TestWithParam<const char*> {
 protected:
  Probe probe = *loadProbe(GetParam());
  ImagingSettings settings = settingsFor(probe);
  BeamGrid grid{probe, settings};
};

TEST_P(BeamGridOf, LocateInvertsOriginAndDirection) {
  for (const double scanline : {0.0, 31.25, 127.5, 200.0, 255.0})
    for (const double sample : {0.0, 10.5, 500.0, 999.0}) {
      const Vec3 p = grid.origin(scanline) + grid.direction(scanline) * grid.range_mm(sample);
      const auto at = grid.locate(p.x, p.z);
      EXPECT_NEAR(at.scanline, scanline, 1e-9);
      EXPECT_NEAR(at.sample, sample, 1e-9);
      EXPECT_TRUE(at.inside);
      EXPECT_EQ(p.y, 0);
    }
}

TEST_P(BeamGridOf, DirectionsAreUnitAndSymmetric) {
  for (const double scanline : {0.0, 60.0, 127.5}) {
    const Vec3 left = grid.direction(scanline), right = grid.direction(255 - scanline);
    EXPECT_NEAR(norm(left), 1, 1e-12);
    EXPECT_NEAR(left.x, -right.x, 1e-12);
    EXPECT_NEAR(grid.origin(scanline).x, -grid.origin(255 - scanline).x, 1e-12);
  }
  EXPECT_NEAR(norm(grid.origin(127.5)), 0, 1e-12) << "the middle of the face is the origin";
}

TEST_P(BeamGridOf, SpacingIsTheDistanceOfNeighbors) {
  for (const double range_mm : {1.0, 20.0, grid.step_mm() * grid.samples()}) {
    const auto point = [&](double l) { return grid.origin(l) + grid.direction(l) * range_mm; };
    EXPECT_NEAR(grid.scanlineSpacing_mm(range_mm), norm(point(127) - point(128)), 1e-4 * range_mm);
  }
}

TEST_P(BeamGridOf, BoundingBoxHoldsTheEdges) {
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
  for (double l = -0.5; l <= 255.5; l += 0.25)
    for (const double range_mm : {0.0, settings.depth_mm}) {
      const Vec3 p = grid.origin(l) + grid.direction(l) * range_mm;
      left = std::min(left, p.x), right = std::max(right, p.x), top = std::min(top, p.z),
      bottom = std::max(bottom, p.z);
    }
  EXPECT_NEAR(grid.minLateral_mm(), left, 1e-9);
  EXPECT_NEAR(grid.maxLateral_mm(), right, 1e-9);
  EXPECT_NEAR(grid.minAxial_mm(), top, 1e-9);
  EXPECT_NEAR(grid.maxAxial_mm(), bottom, 1e-3);
}

TEST_P(BeamGridOf, NothingIsInsideBeyondTheEdgesOrAtNoPoint) {
  EXPECT_FALSE(grid.locate(0, -0.01).inside);
  EXPECT_FALSE(grid.locate(0, settings.depth_mm + 0.01).inside);
  EXPECT_TRUE(grid.locate(0, 0.01).inside);
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(grid.locate(none, 10).inside);
  EXPECT_FALSE(grid.locate(0, none).inside);
}

INSTANTIATE_TEST_SUITE_P(Probes, BeamGridOf, testing::Values("linear", "curvilinear", "phased"),
                         [](const auto& parameter) { return std::string(parameter.param); });

TEST(BeamGrid, KnownGeometry) {
  const Probe linear = *loadProbe("linear");
  const BeamGrid rectangle(linear, settingsFor(linear));
  EXPECT_NEAR(rectangle.origin(0).x, -19 + 19.0 / 256, 1e-12);
  EXPECT_NEAR(rectangle.range_mm(0), 0.02, 1e-12);
  const Probe curved = *loadProbe("curvilinear");
  const BeamGrid fan(curved, settingsFor(curved));
  const double half = curved.fovAngle_deg / 2 * std::numbers::pi / 180;
  EXPECT_NEAR(fan.maxLateral_mm(), (curved.faceRadius_mm + 120) * std::sin(half), 1e-9);
  EXPECT_NEAR(fan.minAxial_mm(), curved.faceRadius_mm * (std::cos(half) - 1), 1e-9);
}

}  // namespace
}  // namespace insonate
