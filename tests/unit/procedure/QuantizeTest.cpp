#include "unit/procedure/HandMotion.h"

#include <gtest/gtest.h>

#include <limits>

namespace insonate {
namespace {

TEST(Quantize, KeepsToItsSteps) {
  for (const AttemptSample& sample : test::handMotion(20'000)) {
    const AttemptSample kept = dequantize(quantize(sample));
    ASSERT_EQ(kept.time_us, sample.time_us);
    ASSERT_NEAR(kept.probeForce_N, sample.probeForce_N, kForceQuantum_N / 2 * 1.001);
    ASSERT_EQ(kept.needleDepth_mm.has_value(), sample.needleDepth_mm.has_value());
    if (sample.needleDepth_mm) {
      ASSERT_NEAR(*kept.needleDepth_mm, *sample.needleDepth_mm, kDistanceQuantum_mm / 2 * 1.001);
    }
    ASSERT_EQ(kept.aspirating, sample.aspirating);
    const Transform &was = *sample.patientFromNeedle, &is = *kept.patientFromNeedle;
    for (int axis = 0; axis < 3; ++axis)
      ASSERT_NEAR(is.offset[axis], was.offset[axis], kPositionQuantum_mm / 2 * 1.001);
    // Points 70 mm up the needle, and aside.
    for (const Vec3 point : {Vec3{0, 0, -70}, Vec3{70, 0, 0}})
      ASSERT_LT(norm(is.linear * point - was.linear * point), 0.001);
  }
}

/// Every rotation, including those near which another component of the quaternion becomes the largest.
TEST(Quantize, RotationsOfAllKinds) {
  for (const Vec3 turned : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, normalized({1, 1, 1})}) {
    for (int step = 0; step <= 720; ++step) {
      const double angle = step * std::numbers::pi / 360;
      Transform pose;
      for (int c = 0; c < 3; ++c) {
        Vec3 e;
        e[c] = 1;
        pose.linear.column[c] = e * std::cos(angle) + cross(turned, e) * std::sin(angle) +
                                turned * (dot(turned, e) * (1 - std::cos(angle)));
      }
      const Transform is = *dequantize(quantize({.patientFromProbe = pose})).patientFromProbe;
      for (int c = 0; c < 3; ++c) ASSERT_LT(norm(is.linear.column[c] - pose.linear.column[c]), 1.5e-5) << step;
      ASSERT_NEAR(determinant(is.linear), 1, 1e-9);
    }
  }
}

TEST(Quantize, TentingIsKept) {
  EXPECT_EQ(dequantize(quantize({.tenting_mm = 2.345})).tenting_mm, 235 * kDistanceQuantum_mm);
}

TEST(Quantize, WhatIsMissingStaysMissing) {
  const AttemptSample kept = dequantize(quantize({.time_us = 7}));
  EXPECT_EQ(kept, (AttemptSample{.time_us = 7}));
}

TEST(Quantize, WhatIsNoPlaceIsHeldByNobody) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Transform broken;
  broken.offset.y = nan;
  EXPECT_FALSE(dequantize(quantize({.patientFromProbe = broken})).patientFromProbe);
  broken = {};
  broken.linear.column[1].z = nan;
  EXPECT_FALSE(dequantize(quantize({.patientFromProbe = broken})).patientFromProbe);
  broken = {};
  broken.offset.x = 2 * kFarthest_mm;
  EXPECT_FALSE(dequantize(quantize({.patientFromNeedle = broken})).patientFromNeedle);
  const AttemptSample odd{.probeForce_N = nan, .toArtery_mm = nan, .toLung_mm = 1e300};
  EXPECT_EQ(dequantize(quantize(odd)).probeForce_N, 0);
  EXPECT_FALSE(dequantize(quantize(odd)).toArtery_mm);
  EXPECT_GT(*dequantize(quantize(odd)).toLung_mm, 1e6);
}

}  // namespace
}  // namespace insonate
