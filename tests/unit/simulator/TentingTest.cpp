#include <insonate/simulator/Tenting.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace insonate {
namespace {

constexpr double kRounding_mm = 1e-4;

Vec3 shiftOf(const PlaneDisplacement& field, Vec3 seen_mm) {
  return shiftAt(field, seen_mm.x, seen_mm.z);
}

/// Smallest volume ratio of the rest position over the displayed position, by the corners of each cell: below 0 it
/// folds.
double minVolume(const PlaneDisplacement& d) {
  double least = 1e9;
  const auto at = [&](int i, int k) { return d.restFromDisplayed[std::size_t(k) * d.columns + i]; };
  for (int k = 0; k + 1 < d.rows; ++k)
    for (int i = 0; i + 1 < d.columns; ++i)
      for (int corner = 0; corner < 4; ++corner) {
        const int a = corner & 1, b = corner >> 1;
        const auto left = at(i, k + b), right = at(i + 1, k + b), top = at(i + a, k), bottom = at(i + a, k + 1);
        const double xx = 1 + (right.x_mm - left.x_mm) / d.step_mm, zx = (right.z_mm - left.z_mm) / d.step_mm;
        const double xz = (bottom.x_mm - top.x_mm) / d.step_mm, zz = 1 + (bottom.z_mm - top.z_mm) / d.step_mm;
        least = std::min(least, xx * zz - xz * zx);
      }
  return least;
}

/// Waves that squeeze by half here and there.
PlaneDisplacement wavy() {
  PlaneDisplacement d{
      .left_mm = -30, .top_mm = -10, .step_mm = 0.5, .columns = 121, .rows = 121, .restFromDisplayed = {}, .lung = {}};
  for (int k = 0; k < d.rows; ++k)
    for (int i = 0; i < d.columns; ++i) {
      const double x = d.left_mm + i * d.step_mm, z = d.top_mm + k * d.step_mm;
      d.restFromDisplayed.push_back({static_cast<float>(1.5 * std::sin(0.3 * x + 0.1 * z)),
                                     static_cast<float>(-2 + 1.5 * std::cos(0.25 * z - 0.1 * x))});
    }
  return d;
}

TEST(Tenting, MovesTheTipsTissueByItsDepthAndNothingFarAway) {
  TentedTissue tissue;
  const Tenting tenting{.tip_mm = {2, 0, 15}, .direction = {0.6, 0, 0.8}, .depth_mm = 2, .radius_mm = 3};
  const PlaneDisplacement& d = tissue.addTenting({}, {}, tenting);
  const Vec3 atTip = shiftOf(d, tenting.tip_mm);
  EXPECT_NEAR(atTip.x, -1.2, kRounding_mm);
  EXPECT_NEAR(atTip.z, -1.6, kRounding_mm);
  for (const Vec3 far : {Vec3{2, 0, 33.5}, Vec3{21, 0, 15}, Vec3{-300, 0, 15}, Vec3{2, 0, -40}})
    EXPECT_EQ(shiftOf(d, far), Vec3{});
}

TEST(Tenting, FollowsTheKernelAlongTheNeedleAndAcross) {
  TentedTissue tissue;
  const double depth = 2, e = 4;
  const PlaneDisplacement& d =
      tissue.addTenting({}, {}, {.tip_mm = {0, 0, 20}, .direction = {0, 0, 1}, .depth_mm = depth, .radius_mm = e});
  const auto window = [&](double r) { return std::pow(1 - r * r / (36 * e * e), 2); };
  for (int n = -18; n <= 18; ++n) {
    const double r = n * d.step_mm, near = std::hypot(r, e), wide = std::hypot(r, 2 * e);
    // On the axis equation 6 comes down to 1/r_e; across it, the part along r vanishes.
    const double along = depth * 2 * e * (1 / near - 1 / wide) * window(r);
    const double across = depth * e * (1 / near + e * e / std::pow(near, 3) - 1 / wide - 4 * e * e / std::pow(wide, 3));
    EXPECT_NEAR(shiftAt(d, 0, 20 + r).z, -along, kRounding_mm) << r;
    EXPECT_NEAR(shiftAt(d, r, 20).z, -across * window(r), kRounding_mm) << r;
  }
}

TEST(Tenting, NeverFolds) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  TentedTissue tissue;
  const PlaneDisplacement pressed = wavy();
  ASSERT_GT(minVolume(pressed), 0.1);
  double least = 1;
  for (int n = 0; n < 300; ++n) {
    const Vec3 direction = normalized({unit(random), unit(random), unit(random)});
    const Tenting tenting{.tip_mm = {15 * unit(random), 3 * unit(random), 20 + 15 * unit(random)},
                          .direction = direction,
                          .depth_mm = 6 + 6 * unit(random),
                          .radius_mm = 3 + 2 * unit(random)};
    const double alone = minVolume(tissue.addTenting({}, {}, tenting));
    EXPECT_GT(alone, 0.05) << n;
    EXPECT_GT(minVolume(tissue.addTenting(pressed, {}, tenting)), 0) << n;
    least = std::min(least, alone);
  }
  RecordProperty("least_volume", std::to_string(least));
}

TEST(Tenting, DentsWhatTheProbeHasPressed) {
  PlaneDisplacement pressed{
      .left_mm = -20, .top_mm = 0, .step_mm = 0.5, .columns = 81, .rows = 81, .restFromDisplayed = {}, .lung = {}};
  pressed.restFromDisplayed.assign(std::size_t(81) * 81, {0.5F, -3});
  const Tenting tenting{.tip_mm = {0, 0, 20}, .direction = {0, 0, 1}, .depth_mm = 2, .radius_mm = 3};
  TentedTissue tissue;
  const PlaneDisplacement& both = tissue.addTenting(pressed, {}, tenting);
  EXPECT_NEAR(shiftAt(both, 0, 20).z, -5, kRounding_mm);
  EXPECT_NEAR(shiftAt(both, 0, 20).x, 0.5, kRounding_mm);
  EXPECT_NEAR(shiftAt(both, -19, 2).z, -3, 0.02);
}

TEST(Tenting, IsSeenInThePosesFrame) {
  Transform pose;  // looks along patient y
  pose.linear = {{Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0, 1, 0}}};
  pose.offset = {10, -50, 0};
  TentedTissue tissue;
  const PlaneDisplacement& d =
      tissue.addTenting({}, pose, {.tip_mm = {13, -30, 0}, .direction = {0, 1, 0}, .depth_mm = 2, .radius_mm = 3});
  EXPECT_NEAR(shiftAt(d, 3, 20).z, -2, kRounding_mm);
  EXPECT_NEAR(shiftAt(d, 3, 20).x, 0, kRounding_mm);
}

TEST(Tenting, WithoutADentIsTheTissueItself) {
  TentedTissue tissue;
  const PlaneDisplacement pressed = wavy();
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (const Tenting& none :
       {Tenting{.tip_mm = {0, 0, 20}, .depth_mm = 0}, Tenting{.tip_mm = {0, 0, 20}, .depth_mm = -1},
        Tenting{.tip_mm = {0, 40, 20}, .depth_mm = 2}, Tenting{.tip_mm = {0, 0, kNaN}, .depth_mm = 2},
        Tenting{.tip_mm = {0, 0, 20}, .depth_mm = kNaN},
        Tenting{.tip_mm = {0, 0, 20}, .depth_mm = 2, .radius_mm = kNaN}})
    EXPECT_EQ(&tissue.addTenting(pressed, {}, none), &pressed);
}

TEST(Tenting, UsesItsMemoryAgain) {
  TentedTissue tissue;
  const Tenting tenting{.tip_mm = {0, 0, 20}, .depth_mm = 3};
  const auto* first = tissue.addTenting({}, {}, tenting).restFromDisplayed.data();
  EXPECT_EQ(tissue.addTenting({}, {.linear = {}, .offset = {1, 0, 2}}, tenting).restFromDisplayed.data(), first);
}

}  // namespace
}  // namespace insonate
