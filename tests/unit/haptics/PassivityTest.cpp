#include "RandomContact.h"

namespace insonate::haptics {
namespace {

class Passivity : public testing::TestWithParam<DeviceProfile> {};

/// Over a million ticks of two hands, all profiles and tissues taken together.
TEST_P(Passivity, NoHandGetsMoreThanItGave) {
  expectPassive(GetParam(), 7000);
}

TEST_P(Passivity, TwoHandsThatMeetGetNoMoreThanTheyGave) {
  const Least least = minEnergy(GetParam(), kMuscle, "measured", 50000, 77, false);
  EXPECT_GE(least.both_J, 0);
}

INSTANTIATE_TEST_SUITE_P(Devices, Passivity, testing::ValuesIn(deviceProfiles().begin(), deviceProfiles().end()),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// The energy account must not be felt: pressed and released as hands do, nearly all of the force arrives.
TEST(Passivity, TheAccountIsHardlyFelt) {
  for (const DeviceProfile& profile : deviceProfiles()) {
    LoopRig rig(profile.limits, layerOf(kMuscle));
    double wanted = 0, sent = 0;
    for (int i = 0; i < 8000; ++i) {
      const double z = 8 - 10 * std::cos(i * 0.001 * 2 * 3.14159265 * 0.5);
      rig.tick({0, {-80, 0, z}, {}}, {0, {0, 0, -30}, {}});
      wanted += std::min(norm(rig.out.tools[0].wanted_N), profile.limits.maxForce_N);
      sent += norm(rig.out.tools[0].force.force_N);
    }
    EXPECT_GT(sent, 0.9 * wanted) << profile.name;
  }
}

}  // namespace
}  // namespace insonate::haptics
