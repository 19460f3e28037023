#include "servo/ForceGuard.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace insonate::haptics {
namespace {

constexpr std::int64_t kTick_ns = 1'000'000;
constexpr GuardLimits kLimits{.force_N = 3, .torque_Nmm = 50, .slew_Npms = 0.5, .silence_ms = 50, .fall_ms = 40};

TEST(ForceGuard, LimitsTheForceAndItsRateOfChange) {
  ForceGuard guard(kLimits);
  const Force wanted{{0, 0, 10}, {100, 0, 0}};
  EXPECT_DOUBLE_EQ(guard.pass(wanted, 0, kTick_ns).force_N.z, 0.5);
  for (int i = 0; i < 20; ++i) guard.pass(wanted, 0, kTick_ns);
  EXPECT_DOUBLE_EQ(norm(guard.last().force_N), 3);
  EXPECT_DOUBLE_EQ(norm(guard.last().torque_Nmm), 50);
  EXPECT_DOUBLE_EQ(guard.pass({}, 0, kTick_ns).force_N.z, 2.5);
}

TEST(ForceGuard, NothingIsLeftAfterAHundredMillisecondsOfSilence) {
  ForceGuard guard(kLimits);
  const Force wanted{{3, 0, 0}, {0, 50, 0}};
  for (int i = 0; i < 20; ++i) guard.pass(wanted, 0, kTick_ns);
  double before = 3;
  for (int ms = 1; ms <= 100; ++ms) {
    const Force f = guard.pass(wanted, ms * kTick_ns, kTick_ns);
    EXPECT_LE(norm(f.force_N), before + 1e-12) << ms << " ms";
    before = norm(f.force_N);
  }
  EXPECT_EQ(norm(guard.last().force_N), 0);
  EXPECT_EQ(norm(guard.last().torque_Nmm), 0);
}

TEST(ForceGuard, WhatIsNotFiniteIsNoForce) {
  ForceGuard guard(kLimits);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Force f = guard.pass({{nan, 0, 0}, {0, nan, 0}}, 0, kTick_ns);
  EXPECT_EQ(norm(f.force_N), 0);
  EXPECT_EQ(norm(f.torque_Nmm), 0);
}

}  // namespace
}  // namespace insonate::haptics
