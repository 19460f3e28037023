#include <insonate/core/Transform.h>

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace insonate {
namespace {

constexpr double kTolerance = 1e-12;

void expectNear(Vec3 actual, Vec3 expected) {
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(actual[a], expected[a], kTolerance) << "axis " << a;
}

Mat3 rotationAboutZ(double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {{Vec3{c, s, 0}, Vec3{-s, c, 0}, Vec3{0, 0, 1}}};
}

TEST(Vec3, CrossIsRightHandedAndSquareToBoth) {
  expectNear(cross({1, 0, 0}, {0, 1, 0}), {0, 0, 1});
  const Vec3 a{1, -2, 3}, b{4, 0.5, -1};
  EXPECT_NEAR(dot(cross(a, b), a), 0, kTolerance);
  EXPECT_NEAR(dot(cross(a, b), b), 0, kTolerance);
}

TEST(Vec3, NormOfAKnownTriangle) {
  EXPECT_DOUBLE_EQ(norm({2, 3, 6}), 7);
  EXPECT_DOUBLE_EQ(norm(normalized({2, 3, 6})), 1);
}

TEST(Vec3, IndexReachesEachCoordinate) {
  Vec3 v;
  for (int a = 0; a < 3; ++a) v[a] = a + 1;
  EXPECT_EQ(v, (Vec3{1, 2, 3}));
}

TEST(Vec3, FiniteNoticesEachBadCoordinate) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(isFinite({1, 2, 3}));
  EXPECT_FALSE(isFinite({nan, 2, 3}));
  EXPECT_FALSE(isFinite({1, infinity, 3}));
  EXPECT_FALSE(isFinite({1, 2, -infinity}));
}

TEST(Transform, ProductAppliesTheRightOneFirst) {
  const Transform turn{rotationAboutZ(std::numbers::pi / 2), {}};
  const Transform shift{{}, {10, 0, 0}};
  expectNear((turn * shift) * Vec3{1, 0, 0}, {0, 11, 0});
  expectNear((shift * turn) * Vec3{1, 0, 0}, {10, 1, 0});
}

TEST(Transform, InverseUndoesScaleMirrorAndShift) {
  Transform t{rotationAboutZ(0.7), {5, -3, 12}};
  t.linear.column[0] = t.linear.column[0] * 0.5;
  t.linear.column[2] = t.linear.column[2] * -4.25;
  const Vec3 point{3, -8, 0.25};
  expectNear(inverted(t) * (t * point), point);
  expectNear(t * (inverted(t) * point), point);
}

TEST(Mat3, DeterminantTellsHandednessAndVolume) {
  EXPECT_DOUBLE_EQ(determinant(Mat3{}), 1);
  EXPECT_DOUBLE_EQ(determinant(Mat3{{Vec3{2, 0, 0}, Vec3{0, 3, 0}, Vec3{0, 0, -4}}}), -24);
  EXPECT_NEAR(determinant(rotationAboutZ(1.1)), 1, kTolerance);
}

}  // namespace
}  // namespace insonate
