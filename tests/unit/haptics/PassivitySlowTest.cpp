#include "RandomContact.h"

namespace insonate::haptics {
namespace {

class PassivityAtLength : public testing::TestWithParam<DeviceProfile> {};

/// A million ticks for each profile and tissue: half a million with each table.
TEST_P(PassivityAtLength, NoHandGetsMoreThanItGave) {
  expectPassive(GetParam(), 500000);
}

TEST_P(PassivityAtLength, TwoHandsThatMeetGetNoMoreThanTheyGave) {
  for (unsigned seed = 1; seed <= 20; ++seed)
    EXPECT_GE(minEnergy(GetParam(), kMuscle, "measured", 50000, 300 + seed, false).both_J, 0) << seed;
}

INSTANTIATE_TEST_SUITE_P(Devices, PassivityAtLength,
                         testing::ValuesIn(deviceProfiles().begin(), deviceProfiles().end()),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace insonate::haptics
