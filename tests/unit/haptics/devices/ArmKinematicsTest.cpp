#include "devices/ArmKinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace insonate;
using insonate::haptics::ArmKinematics;

namespace {

ArmTable arm() {
  for (const DeviceTable& table : builtInDeviceTables())
    if (table.name == "WoodenHaptics") return *table.arm;
  throw std::runtime_error("no such device");
}

constexpr double kRight = std::numbers::pi / 2;

TEST(ArmKinematics, KnownPostures) {
  ArmTable table = arm();
  table.center_mm = {};
  const ArmKinematics k(table);
  const auto [la, lb, lc] = table.length_mm;
  // Upper bar upright, lower bar hanging: over the turret.
  const Vec3 hanging = k.position_mm({0, 0, 0});
  EXPECT_NEAR(norm(hanging - Vec3{0, la + lb - lc, 0}), 0, 1e-9);
  // Lower bar level: to the user (z), then, the turret turned, to the right (x).
  EXPECT_NEAR(norm(k.position_mm({0, 0, kRight}) - Vec3{0, la + lb, lc}), 0, 1e-9);
  EXPECT_NEAR(norm(k.position_mm({kRight, 0, kRight}) - Vec3{lc, la + lb, 0}), 0, 1e-9);
}

TEST(ArmKinematics, AMotorsTurnTurnsItsBodyByTheReduction) {
  const ArmTable table = arm();
  const auto angles = ArmKinematics(table).anglesOf({2000, -2000, 0});
  EXPECT_NEAR(angles[0], -2 * std::numbers::pi / 16, 1e-12);
  EXPECT_NEAR(angles[1], 2 * std::numbers::pi / 12, 1e-12);
  EXPECT_NEAR(angles[2], kRight, 1e-12) << "level at home";
}

TEST(ArmKinematics, CurrentsDoTheWorkThatTheForceDoes) {
  ArmTable table = arm();
  table.maxCurrent_mA = 1e9;
  const ArmKinematics k(table);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 200; ++i) {
    const std::array<double, 3> counts{1000 * any(random), 1500 * any(random), 6000 * any(random)};
    const Vec3 force{5 * any(random), 5 * any(random), 5 * any(random)};
    const auto current = k.currents_mA(k.anglesOf(counts), force);
    for (std::size_t m = 0; m < 3; ++m) {
      auto more = counts, less = counts;
      more[m] += 0.5;
      less[m] -= 0.5;
      const Vec3 way = k.position_mm(k.anglesOf(more)) - k.position_mm(k.anglesOf(less));
      const double turned = 2 * std::numbers::pi / table.countsPerTurn[m];
      EXPECT_NEAR(current[m] * table.torque_NmmPermA[m] * turned, dot(force, way), 1e-6);
    }
  }
}

TEST(ArmKinematics, TooMuchIsWeakerInTheSameDirection) {
  ArmTable table = arm();
  table.maxCurrent_mA = 1e9;
  const std::array<double, 3> angles{0.2, 0.3, 1};
  const auto all = ArmKinematics(table).currents_mA(angles, {30, 20, -10});
  table.maxCurrent_mA = 100;
  const auto held = ArmKinematics(table).currents_mA(angles, {30, 20, -10});
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(held[i] * all[0], all[i] * held[0], 1e-6);
    most = std::max(most, std::abs(held[i]));
  }
  EXPECT_NEAR(most, 100, 1e-9);
}

}  // namespace
