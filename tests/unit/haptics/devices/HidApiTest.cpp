// hidapi as it is installed, on devices that umockdev shows to it: run by umockdev-wrapper.
#include "Descriptor.h"
#include "MockHidraw.h"

#include <insonate/haptics/DeviceHub.h>
#include <insonate/haptics/ReportDecoder.h>

#include <gmock/gmock.h>

#include <chrono>
#include <memory>
#include <thread>

using namespace insonate;
using namespace insonate::test;
using namespace std::chrono_literals;

namespace {

/// A vendor's page, one collection: all that hidapi reads of it is usage page and usage.
const Bytes kVendorDescriptor{0x06, 0xAB, 0xFF, 0x0A, 0x00, 0x02, 0xA1, 0x01, 0xC0};
const Bytes kCapDescriptor{0x05, 0x01, 0x09, 0x08, 0xA1, 0x01, 0xC0};

class HidApiTest : public testing::Test {
 protected:
  void SetUp() override {
    machine_ = std::make_unique<MockMachine>();
    if (!umockdev_in_mock_environment()) GTEST_SKIP() << "not run by umockdev-wrapper";
    hub_ = std::make_unique<DeviceHub>(usbDevices(), HubOptions{.rescan = 20ms});
    hub_->start();
  }
  void TearDown() override { hub_.reset(); }

  std::unique_ptr<MockHidraw> plugArm(int number) {
    return std::make_unique<MockHidraw>(*machine_, number, 0x16c0, 0x0486, "WoodenHaptics", "A7", kVendorDescriptor);
  }
  std::shared_ptr<HapticDevice> inPhase(const std::string& id, DevicePhase phase) {
    std::shared_ptr<HapticDevice> found;
    EXPECT_TRUE(eventually([&] {
      for (const auto& d : hub_->devices())
        if (d->info().id == id) found = d;
      return found && found->phase() == phase;
    })) << id
        << " is not " << nameOf(phase) << (found ? " but " + std::string(nameOf(found->phase())) + found->error() : "");
    return found;
  }

  std::unique_ptr<MockMachine> machine_;
  std::unique_ptr<DeviceHub> hub_;
};

TEST_F(HidApiTest, APluggedDeviceIsFoundByItsUsageAndItsReportsArrive) {
  MockHidraw cap(*machine_, 0, 0x256f, 0xc635, "SpaceMouse Compact", "", kCapDescriptor);
  const auto device = inPhase("256f:c635", DevicePhase::kReady);
  ASSERT_TRUE(device);
  EXPECT_EQ(device->info().name, "SpaceMouse Compact");
  EXPECT_EQ(device->info().kind, DeviceKind::kMotion);
  cap.say({3, 2, 0});
  inPhase("256f:c635", DevicePhase::kStreaming);
  DeviceState state;
  ASSERT_TRUE(eventually([&] { return device->pollState(state); }));
  EXPECT_EQ(state.buttons, 2U);
  // The device moves to the right without a pause.
  ASSERT_TRUE(eventually([&] {
    cap.say({1, 0x5E, 0x01, 0, 0, 0, 0});
    std::this_thread::sleep_for(10ms);
    device->pollState(state);
    return state.deviceFromStylus.offset.x > 1;
  }));
  EXPECT_EQ(state.deviceFromStylus.offset.y, 0);
}

TEST_F(HidApiTest, ReportsThatWaitTogetherStayApart) {
  auto arm = plugArm(0);
  const auto device = inPhase("16c0:0486/A7", DevicePhase::kReady);
  ASSERT_TRUE(device);
  for (int i = 0; i < 20; ++i) arm->say(armReport(100 * i));
  ASSERT_TRUE(eventually([&] { return device->counters().reports == 20; }));
  EXPECT_EQ(device->counters().refused, 0U);
}

TEST_F(HidApiTest, ForcesArriveAsTheBytesOfTheProtocol) {
  auto arm = plugArm(0);
  const auto device = inPhase("16c0:0486/A7", DevicePhase::kReady);
  ASSERT_TRUE(device);
  arm->say(armReport(0));
  inPhase("16c0:0486/A7", DevicePhase::kStreaming);
  for (int i = 0; i < 50; ++i) {
    arm->say(armReport(0));
    device->push({{0, 0, 2}, {}});
    std::this_thread::sleep_for(1ms);
  }
  ASSERT_TRUE(eventually([&] { return !arm->heard().empty(); }));
  const Bytes sent = arm->heard().at(0);
  ASSERT_EQ(sent.size(), 15U);
  EXPECT_EQ(sent[0], 0);
  // At home the upper bar stands upright: 2 N to the user on 205 mm, geared down 12 times, 0.0259 N mm for 1 mA. The
  // lower one is level, and a pull along it asks nothing of its motor.
  const auto payload = std::span<const std::uint8_t>(sent).subspan(1);
  EXPECT_EQ(signedValue(bitsAt(payload, 0, 16), 16), 0);
  EXPECT_NEAR(signedValue(bitsAt(payload, 16, 16), 16), -2 * 205 / 12.0 / 0.0259, 1);
  EXPECT_NEAR(signedValue(bitsAt(payload, 32, 16), 16), 0, 1);
}

TEST_F(HidApiTest, AHomeBuiltDeviceIsKnownByItsDescriptor) {
  MockHidraw own(*machine_, 0, 0x1209, 0x0001, "Hand", "1", insonateDescriptor());
  MockHidraw other(*machine_, 1, 0x1209, 0x0001, "Something else", "2", kVendorDescriptor);
  const auto device = inPhase("1209:0001/1", DevicePhase::kReady);
  ASSERT_TRUE(device);
  Bytes report(31, 0);
  report[0] = 1;
  report[2] = 0x10;  // 4096 micrometers to the right
  report[13] = 0x40;
  own.say(report);
  DeviceState state;
  ASSERT_TRUE(eventually([&] { return device->pollState(state); }));
  EXPECT_NEAR(state.deviceFromStylus.offset.x, 4.096, 1e-9);
  EXPECT_EQ(state.deviceFromStylus.linear, Mat3{});
  EXPECT_EQ(hub_->devices().size(), 1U);
}

TEST_F(HidApiTest, UnpluggedInContactItIsLostAndComesBackWithoutAForce) {
  auto arm = plugArm(0);
  const auto device = inPhase("16c0:0486/A7", DevicePhase::kReady);
  ASSERT_TRUE(device);
  std::jthread pushing([&](const std::stop_token& stop) {
    for (; !stop.stop_requested(); std::this_thread::sleep_for(2ms)) device->push({{0, 0, 2}, {}});
  });
  ASSERT_TRUE(eventually([&] {
    arm->say(armReport(1));
    std::this_thread::sleep_for(2ms);
    return !arm->heard().empty() && !isZero(arm->heard().back());
  }));
  arm->unplug();
  inPhase("16c0:0486/A7", DevicePhase::kLost);
  EXPECT_THAT(device->error(), testing::HasSubstr("unplugged"));
  pushing = {};

  const auto again = plugArm(1);  // another node for the same device
  EXPECT_EQ(inPhase("16c0:0486/A7", DevicePhase::kReady), device);
  again->say(armReport(1));
  inPhase("16c0:0486/A7", DevicePhase::kStreaming);
  std::this_thread::sleep_for(50ms);
  for (const Bytes& report : again->heard()) EXPECT_TRUE(isZero(report));
}

}  // namespace
