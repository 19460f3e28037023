#include <insonate/views/Caliper.h>

#include <gtest/gtest.h>

#include <numbers>

namespace insonate::views {
namespace {

TEST(Caliper, DistanceIsPythagoras) {
  const Caliper caliper{CaliperKind::Distance, {{{1, 2}, {4, 6}, {}}}};
  EXPECT_DOUBLE_EQ(measure(caliper).length_mm, 5);
  EXPECT_EQ(caliperText(caliper), "5.0 mm");
}

TEST(Caliper, EllipseOfEqualAxesIsACircle) {
  const Caliper caliper{CaliperKind::Ellipse, {{{-5, 10}, {5, 10}, {2, 15}}}};
  const CaliperValues values = measure(caliper);
  EXPECT_DOUBLE_EQ(values.width_mm, 10);
  EXPECT_NEAR(values.area_mm2, 25 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(values.circumference_mm, 10 * std::numbers::pi, 1e-9);
  EXPECT_EQ(caliperText(caliper), "10.0 × 10.0 mm, 79 mm²");
}

TEST(Caliper, EllipseTakesTheThirdPointsDistanceFromTheAxis) {
  // Turned by 45 degrees; perimeter of axes 6 and 2: 4 a E(e), from the elliptic integral.
  const double r = 3 / std::numbers::sqrt2, s = 1 / std::numbers::sqrt2;
  const CaliperValues values = measure({CaliperKind::Ellipse, {{{-r, -r}, {r, r}, {-s, s}}}});
  EXPECT_NEAR(values.length_mm, 6, 1e-9);
  EXPECT_NEAR(values.width_mm, 2, 1e-9);
  EXPECT_NEAR(values.circumference_mm, 13.3648932, 1e-4);
}

TEST(Caliper, AngleLiesAtTheMiddlePoint) {
  EXPECT_NEAR(measure({CaliperKind::Angle, {{{10, 0}, {0, 0}, {0, 7}}}}).angle_deg, 90, 1e-9);
  EXPECT_NEAR(measure({CaliperKind::Angle, {{{-1, 1}, {0, 0}, {3, 0}}}}).angle_deg, 135, 1e-9);
  EXPECT_EQ(caliperText({CaliperKind::Angle, {{{0, 0}, {0, 0}, {3, 0}}}}), "0°");
}

}  // namespace
}  // namespace insonate::views
