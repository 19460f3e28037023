#include "devices/Rotation.h"
#include "devices/StateMaker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace insonate;
using namespace insonate::haptics;

namespace {

constexpr std::int64_t kMillisecond = 1'000'000;

const DeviceTable& tableNamed(const std::string& name) {
  for (const DeviceTable& table : builtInDeviceTables())
    if (table.name.starts_with(name)) return table;
  throw std::runtime_error("no table " + name);
}

double difference(const Mat3& a, const Mat3& b) {
  return norm(a.column[0] - b.column[0]) + norm(a.column[1] - b.column[1]) + norm(a.column[2] - b.column[2]);
}

TEST(Rotation, AQuaternionTurnsAsItSays) {
  const double half = std::sqrt(0.5);
  const Mat3 aboutZ = rotationOf({half, 0, 0, half});
  EXPECT_NEAR(norm(aboutZ * Vec3{1, 0, 0} - Vec3{0, 1, 0}), 0, 1e-12);
  EXPECT_NEAR(difference(aboutZ, turned({}, {0, 0, std::numbers::pi / 2})), 0, 1e-12);
  EXPECT_EQ(rotationOf({0, 0, 0, 0}), Mat3{});
  EXPECT_NEAR(difference(rotationOf({0.9, 0, 0, 0}), {}), 0, 1e-12);  // rounded by the device
}

TEST(Rotation, ATurnIsFoundAgainUpToHalfACircle) {
  std::mt19937 random(3);
  std::normal_distribution<double> any;
  for (const double angle : {1e-9, 1e-4, 1.0, 3.0, std::numbers::pi - 1e-7, std::numbers::pi}) {
    for (int i = 0; i < 50; ++i) {
      const Vec3 turn = normalized({any(random), any(random), any(random)}) * angle;
      const Mat3 rotation = turned({}, turn);
      EXPECT_NEAR(difference(turned({}, turnOf(rotation)), rotation), 0, 1e-6) << angle;
      EXPECT_LE(norm(turnOf(rotation)), std::numbers::pi + 1e-9);
    }
  }
}

TEST(StateMaker, ACapMovesTheStylusWhileItIsPressed) {
  StateMaker maker(tableNamed("SpaceMouse"));
  DeviceReading reading;
  reading.deflection = {1, 0, 0, 0, 0, 0};
  std::int64_t now = 1000 * kMillisecond;
  DeviceState state;
  for (int i = 0; i <= 1000; ++i, now += kMillisecond) state = maker.make(reading, now, now);
  EXPECT_NEAR(state.deviceFromStylus.offset.x, StateMaker::kCapSpeed_mmps, 0.1);
  EXPECT_NEAR(state.velocity_mmps.x, StateMaker::kCapSpeed_mmps, 1e-9);
  reading.deflection = {0.04, 0, 0, 0, -0.04, 0};  // a hand that rests on it
  state = maker.make(reading, now, now);
  EXPECT_EQ(norm(state.velocity_mmps) + norm(state.angularVelocity_radps), 0);
}

TEST(StateMaker, ACapThatFallsSilentWhilePressedStops) {
  StateMaker maker(tableNamed("SpaceMouse"));
  DeviceReading reading;
  reading.deflection = {0, 0, 0, 0, 0, 1};
  const std::int64_t last = 1000 * kMillisecond;
  for (int i = 0; i < 1000; ++i) maker.make(reading, last, last + i * kMillisecond);
  const DeviceState state = maker.make(reading, last, last + 1000 * kMillisecond);
  EXPECT_EQ(norm(state.angularVelocity_radps), 0);
  EXPECT_NEAR(norm(turnOf(state.deviceFromStylus.linear)), 0.25 * StateMaker::kCapTurn_radps, 0.01);
}

TEST(StateMaker, CalibratingPutsTheArmInItsHomePosture) {
  StateMaker maker(tableNamed("WoodenHaptics"));
  DeviceReading reading;
  const Vec3 home = maker.make(reading, 1, 1).deviceFromStylus.offset;
  reading.encoder = {500, -700, 2000, 0, 0, 0};
  EXPECT_GT(norm(maker.make(reading, 2, 2).deviceFromStylus.offset - home), 10);
  maker.calibrate(reading);
  EXPECT_NEAR(norm(maker.make(reading, 3, 3).deviceFromStylus.offset - home), 0, 1e-9);
  maker.reset();
  EXPECT_GT(norm(maker.make(reading, 4, 4).deviceFromStylus.offset - home), 10);
}

}  // namespace
