#include "FakeBus.h"
#include "devices/Rotation.h"

#include <insonate/haptics/DeviceHub.h>
#include <insonate/haptics/VendorKit.h>

#include <gmock/gmock.h>

#include <numbers>

using namespace insonate;
using namespace insonate::test;
using namespace std::chrono_literals;

namespace {

/// Behavior of the vendor's device.
struct Desk {
  std::mutex mutex;
  bool plugged = true, refuses = false;
  DeviceState state;
  Force force;
  int writes = 0;

  template <class F>
  auto with(F f) {
    const std::lock_guard lock(mutex);
    return f();
  }
};

Desk& desk() {
  static Desk one;
  return one;
}

class TestHandle final : public VendorHandle {
 public:
  bool read(DeviceState& state) noexcept override {
    const std::lock_guard lock(desk().mutex);
    state = desk().state;
    return desk().plugged;
  }
  bool write(const Force& force) noexcept override {
    const std::lock_guard lock(desk().mutex);
    desk().force = force;
    ++desk().writes;
    return desk().plugged;
  }
};

class TestKit final : public VendorKit {
 public:
  std::string_view name() const override { return "test"; }
  std::vector<VendorFound> list() override {
    const std::lock_guard lock(desk().mutex);
    if (!desk().plugged) return {};
    DeviceLimits limits;
    limits.sensedAxes = 6;
    limits.forceAxes = 3;
    limits.maxForce_N = 8;
    limits.rate_Hz = 1000;
    return {{"42", "Test stylus", limits}};
  }
  Result<std::unique_ptr<VendorHandle>> open(const VendorFound& found) override {
    EXPECT_EQ(found.serial, "42");
    if (desk().refuses) return fail("The kit has no licence on this machine.");
    return std::make_unique<TestHandle>();
  }
};

}  // namespace

namespace insonate {
/// As a site defines it; CMake lists it for this program.
std::unique_ptr<VendorKit> makeVendorKit_test() {
  return std::make_unique<TestKit>();
}
}  // namespace insonate

namespace {

class VendorKitTest : public testing::Test {
 protected:
  VendorKitTest() {
    desk().with([] {
      desk().plugged = true;
      desk().refuses = false;
      desk().writes = 0;
      desk().force = {};
      desk().state = {{haptics::turned({}, {0, std::numbers::pi / 3, 0}), {12.345, -6.789, 0.001}}, {}, {}, 0x102, 0};
    });
  }
  std::shared_ptr<HapticDevice> only(DeviceHub& hub, DevicePhase phase) {
    EXPECT_TRUE(eventually([&] { return hub.devices().size() == 1 && hub.devices()[0]->phase() == phase; }));
    return hub.devices().empty() ? nullptr : hub.devices()[0];
  }
};

TEST_F(VendorKitTest, WhatIsBuiltInIsListed) {
  const auto kits = builtInVendorKits();
  ASSERT_EQ(kits.size(), 1U);
  EXPECT_EQ(kits[0]->name(), "test");
}

TEST_F(VendorKitTest, ItsDeviceLivesAsAllOthersDo) {
  DeviceHub hub(devicesOf(std::move(builtInVendorKits().at(0))), {.rescan = 5ms});
  hub.start();
  const auto device = only(hub, DevicePhase::kStreaming);
  ASSERT_TRUE(device);
  EXPECT_EQ(device->info().name, "Test stylus");
  EXPECT_EQ(device->info().limits.maxForce_N, 8);
  DeviceState state;
  ASSERT_TRUE(eventually([&] { return device->pollState(state); }));
  EXPECT_NEAR(norm(state.deviceFromStylus.offset - Vec3{12.345, -6.789, 0.001}), 0, 1e-9);
  const auto wanted = haptics::turned({}, {0, std::numbers::pi / 3, 0});
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(norm(state.deviceFromStylus.linear.column[i] - wanted.column[i]), 0, 1e-4);
  EXPECT_EQ(state.buttons, 0x102U);

  device->push({{0, -20, 0}, {5, 5, 5}});  // beyond its limits
  ASSERT_TRUE(eventually([] { return desk().with([] { return norm(desk().force.force_N) > 0; }); }));
  EXPECT_EQ(desk().with([] { return desk().force.force_N; }), (Vec3{0, -8, 0}));
  EXPECT_EQ(desk().with([] { return desk().force.torque_Nmm; }), Vec3{});

  desk().with([] { desk().plugged = false; });
  only(hub, DevicePhase::kLost);
  desk().with([] { desk().plugged = true; });
  EXPECT_EQ(only(hub, DevicePhase::kStreaming), device);
}

TEST_F(VendorKitTest, WhyTheKitRefusesIsSaid) {
  desk().refuses = true;
  DeviceHub hub(devicesOf(std::make_unique<TestKit>()));
  hub.scanOnce();
  EXPECT_EQ(only(hub, DevicePhase::kFailed)->error(), "The kit has no licence on this machine.");
}

}  // namespace
