#include <insonate/haptics/SimulatedHand.h>

#include <gmock/gmock.h>

#include <cmath>

namespace insonate {
namespace {

constexpr DeviceLimits freeDevice() {
  DeviceLimits device;
  device.maxForce_N = 10, device.rate_Hz = 1000, device.mass_kg = 0.05;
  return device;
}
constexpr DeviceLimits kFree = freeDevice();

/// Grip and mass are an oscillator: its frequency and decay are known.
TEST(SimulatedHand, SwingsAsMassAndGripSay) {
  const Grip grip{.mass_kg = 0.15, .stiffness_Npmm = 0.2, .damping_Nspm = 1};
  SimulatedHand hand(kFree, grip, {10, 0, 0});
  const double omega0 = std::sqrt(200 / 0.2), zeta = 1 / (2 * 0.2 * omega0);
  const double omega = omega0 * std::sqrt(1 - zeta * zeta);
  for (int i = 1; i <= 200; ++i) {
    hand.move({0, {}, {}}, {}, 0.001);
    const double t = i * 0.001;
    const double exact =
        10 * std::exp(-zeta * omega0 * t) * (std::cos(omega * t) + zeta * omega0 / omega * std::sin(omega * t));
    EXPECT_NEAR(hand.position_mm().x, exact, 0.03) << i;
  }
}

TEST(SimulatedHand, FrictionHoldsItStill) {
  DeviceLimits device = kFree;
  device.friction_N = 0.3;
  SimulatedHand hand(device, {.mass_kg = 0.1, .stiffness_Npmm = 0.5, .damping_Nspm = 40}, {});
  for (int i = 0; i < 500; ++i) hand.move({0, {0.5, 0, 0}, {}}, {}, 0.001);
  EXPECT_NEAR(hand.position_mm().x, 0, 1e-9);  // 0.25 N do not move it
  for (int i = 0; i < 500; ++i) hand.move({0, {2, 0, 0}, {}}, {}, 0.001);
  EXPECT_NEAR(hand.position_mm().x, 1.4, 0.05);  // until 0.3 N are left
  EXPECT_GT(hand.lost_J(), 0.3e-3);
}

TEST(SimulatedHand, EncodersRoundAndForcesEnd) {
  DeviceLimits device = kFree;
  device.resolution_mm = 0.05;
  device.maxForce_N = 1;
  SimulatedHand hand(device, {.mass_kg = 0.1, .stiffness_Npmm = 0.5, .damping_Nspm = 5}, {0.26, 0.02, 0});
  EXPECT_NEAR(hand.state(7).deviceFromStylus.offset.x, 0.25, 1e-12);
  EXPECT_EQ(hand.state(7).deviceFromStylus.offset.y, 0);
  EXPECT_EQ(hand.state(7).time_ns, 7);
  for (int i = 0; i < 3000; ++i) hand.move({0, {}, {}}, {{5, 0, 0}, {}}, 0.001);
  EXPECT_NEAR(hand.position_mm().x, 2, 0.01);  // 1 N on 0.5 N/mm
}

TEST(SimulatedHand, WorkIsForceTimesWay) {
  SimulatedHand hand(kFree, {}, {});
  for (int i = 0; i < 2000; ++i) hand.move({0, {}, {}}, {{1, 0, 0}, {}}, 0.001);
  EXPECT_NEAR(hand.intoLoop_J(), -1e-3 * hand.position_mm().x, 1e-9);
}

TEST(PassiveStiffness, ColgateAndFriction) {
  DeviceLimits device = kFree;
  device.damping_Nspm = 0.2;
  EXPECT_NEAR(passiveStiffness_Npmm(device, 0, 100), 0.4, 1e-12);  // b = K T / 2: 400 N/m at 1 kHz need 0.2 N s/m
  EXPECT_NEAR(passiveStiffness_Npmm(device, 0.1, 100), 0.2, 1e-12);
  device.damping_Nspm = 0;
  device.friction_N = 0.05;
  device.resolution_mm = 0.05;
  EXPECT_NEAR(passiveStiffness_Npmm(device, 0, 100), 1, 1e-12);  // 2 * 0.05 / (0.001 * 100)
  EXPECT_NEAR(passiveStiffness_Npmm(device, 0, 10), 2, 1e-12);   // 2 * 0.05 / 0.05
}

TEST(PassivityObserver, SeesWhatComesBackAndForgetsWhatWasLost) {
  PassivityObserver observer;
  observer.add(0, false);
  observer.add(2, true);
  observer.add(1, true);
  EXPECT_EQ(observer.minEnergy_J(), 0);
  observer.add(1, false);
  observer.add(0.5, true);
  EXPECT_DOUBLE_EQ(observer.minEnergy_J(), -0.5);
}

TEST(HandPath, GoesFromPointToPoint) {
  const auto path = parseHandPath("# a press\n0,0,0,0\n1,10,0,-4\n\n3,10,2,-4\n");
  ASSERT_TRUE(path) << path.error().message;
  EXPECT_EQ(path->at(-1).position_mm, (Vec3{0, 0, 0}));
  EXPECT_NEAR(path->at(0.5).position_mm.x, 5, 1e-12);
  EXPECT_NEAR(path->at(2).position_mm.y, 1, 1e-12);
  EXPECT_EQ(path->at(9).position_mm, (Vec3{10, 2, -4}));
  const auto again = parseHandPath(textOf(*path));
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->points.size(), 3U);
  EXPECT_EQ(again->at(2).position_mm, path->at(2).position_mm);
}

TEST(HandPath, SaysWhichLineIsWrong) {
  using testing::HasSubstr;
  EXPECT_THAT(parseHandPath("").error().message, HasSubstr("no points"));
  EXPECT_THAT(parseHandPath("0,1,2,3\n1,2,x,4").error().message, HasSubstr("Line 2: 'x' is not a number."));
  EXPECT_THAT(parseHandPath("0,1,2").error().message, HasSubstr("Line 1 has 3 numbers"));
  EXPECT_THAT(parseHandPath("1,0,0,0\n1,0,0,0").error().message, HasSubstr("times must increase"));
  EXPECT_THAT(parseHandPath("1,0,0,0,1,0,0,0,1,0,0,0,2").error().message, HasSubstr("not a rotation"));
}

}  // namespace
}  // namespace insonate
