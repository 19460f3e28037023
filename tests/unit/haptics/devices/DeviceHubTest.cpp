#include "FakeBus.h"

#include <insonate/haptics/DeviceHub.h>
#include <insonate/haptics/ReportDecoder.h>

#include <gmock/gmock.h>

using namespace insonate;
using namespace insonate::test;
using namespace std::chrono_literals;
using testing::HasSubstr;

namespace {

const haptics::HidFound kArm{"/dev/hidraw0", "Maker", "Arm", "7", 0x16c0, 0x0486, 0xffab, 0x0200};
const haptics::HidFound kPedal{"/dev/hidraw1", "VEC", "", "", 0x05f3, 0x00ff, 1, 0};

class DeviceHubTest : public testing::Test {
 protected:
  DeviceHubTest() { hub_.start(); }

  std::shared_ptr<HapticDevice> device(const std::string& id) {
    for (const auto& d : hub_.devices())
      if (d->info().id == id) return d;
    return nullptr;
  }
  std::shared_ptr<HapticDevice> inPhase(const std::string& id, DevicePhase phase) {
    EXPECT_TRUE(eventually([&] { return device(id) && device(id)->phase() == phase; }))
        << id << " is not " << nameOf(phase) << (device(id) ? device(id)->error() : " and not known");
    return device(id);
  }
  /// An arm that tells where it is each millisecond until it is pulled.
  void stream(const std::shared_ptr<FakeCable>& cable) {
    talker_ = std::jthread([cable](const std::stop_token& stop) {
      for (int i = 0; !stop.stop_requested(); ++i, std::this_thread::sleep_for(1ms)) cable->say(armReport(i));
    });
  }

  std::shared_ptr<FakePorts> ports_ = std::make_shared<FakePorts>();
  std::jthread talker_;
  DeviceHub hub_{std::make_unique<FakeBus>(ports_), {.rescan = 5ms}};
};

TEST_F(DeviceHubTest, APedalGoesThroughItsLife) {
  EXPECT_TRUE(hub_.devices().empty());
  const auto cable = ports_->plug(kPedal);
  const auto pedal = inPhase("05f3:00ff", DevicePhase::kReady);
  EXPECT_EQ(pedal->info().name, "VEC Infinity IN-USB-2");  // the table's, where the device tells none
  EXPECT_EQ(pedal->info().kind, DeviceKind::kPedal);
  cable->say({2, 0});
  inPhase("05f3:00ff", DevicePhase::kStreaming);
  DeviceState state;
  ASSERT_TRUE(eventually([&] { return pedal->pollState(state); }));
  EXPECT_EQ(state.buttons, 2U);
  EXPECT_FALSE(pedal->pollState(state));  // once
  EXPECT_EQ(pedal->counters().reports, 1U);
  std::this_thread::sleep_for(300ms);
  EXPECT_EQ(pedal->phase(), DevicePhase::kStreaming);  // a foot may rest

  ports_->unplug("/dev/hidraw1");
  inPhase("05f3:00ff", DevicePhase::kLost);
  EXPECT_THAT(pedal->error(), HasSubstr("unplugged"));

  haptics::HidFound elsewhere = kPedal;
  elsewhere.path = "/dev/hidraw9";
  const auto again = ports_->plug(elsewhere);
  EXPECT_EQ(inPhase("05f3:00ff", DevicePhase::kReady), pedal);
  EXPECT_EQ(pedal->error(), "");
  again->say({4, 0});
  ASSERT_TRUE(eventually([&] { return pedal->pollState(state); }));
  EXPECT_EQ(state.buttons, 4U);

  std::vector<DevicePhase> phases;
  for (const DeviceEvent& e : hub_.takeEvents()) {
    phases.push_back(e.phase);
    EXPECT_EQ(e.error, e.phase == DevicePhase::kLost) << e.text;
    EXPECT_EQ(e.text.back(), '.');
  }
  using enum DevicePhase;
  EXPECT_THAT(phases, testing::ElementsAre(kOpening, kReady, kStreaming, kLost, kOpening, kReady, kStreaming));
  EXPECT_TRUE(hub_.takeEvents().empty());
}

TEST_F(DeviceHubTest, MissingRightsAreSaidOnceAndFixedWithoutARestart) {
  ports_->locked = "/dev/hidraw1 may not be opened.";
  ports_->plug(kPedal);
  const auto pedal = inPhase("05f3:00ff", DevicePhase::kFailed);
  EXPECT_EQ(pedal->error(), "/dev/hidraw1 may not be opened.");
  std::this_thread::sleep_for(50ms);  // ten more attempts
  EXPECT_EQ(hub_.takeEvents().size(), 2U);
  {
    const std::lock_guard lock(ports_->mutex);
    ports_->locked = "";
  }
  inPhase("05f3:00ff", DevicePhase::kReady);
}

TEST_F(DeviceHubTest, OneThatFailedAndIsPulledIsAbsent) {
  ports_->locked = "No.";
  ports_->plug(kPedal);
  inPhase("05f3:00ff", DevicePhase::kFailed);
  ports_->unplug("/dev/hidraw1");
  inPhase("05f3:00ff", DevicePhase::kAbsent);
}

TEST_F(DeviceHubTest, StrangersAreLeftAlone) {
  haptics::HidFound mouse = kPedal;
  mouse.product = 0x0001;
  ports_->plug(mouse);
  std::this_thread::sleep_for(50ms);
  EXPECT_TRUE(hub_.devices().empty());
}

TEST_F(DeviceHubTest, ControllersThatShareAnIdAreToldApartByTheirName) {
  haptics::HidFound polhem = kArm;
  polhem.name = "POLHEM haptics", polhem.serial = "8";
  polhem.path = "/dev/hidraw7";
  const auto cable = ports_->plug(kArm), other = ports_->plug(polhem);
  inPhase("16c0:0486/7", DevicePhase::kReady);
  inPhase("16c0:0486/8", DevicePhase::kReady);
  EXPECT_EQ(device("16c0:0486/7")->info().limits.maxStiffness_Npmm, 1);
  EXPECT_EQ(device("16c0:0486/8")->info().limits.maxStiffness_Npmm, 0.8) << "the Polhem's";
}

TEST_F(DeviceHubTest, TwoAlikeAreTwoDevices) {
  haptics::HidFound left = kArm, right = kPedal, other = kPedal;
  other.path = "/dev/hidraw5";
  ports_->plug(left);
  ports_->plug(right);
  ports_->plug(other);
  inPhase("16c0:0486/7", DevicePhase::kReady);
  inPhase("05f3:00ff", DevicePhase::kReady);
  inPhase("05f3:00ff#2", DevicePhase::kReady);
  ports_->unplug("/dev/hidraw1");
  inPhase("05f3:00ff", DevicePhase::kLost);
  EXPECT_EQ(device("05f3:00ff#2")->phase(), DevicePhase::kReady);
  ports_->plug(right);
  inPhase("05f3:00ff", DevicePhase::kReady);
  EXPECT_EQ(hub_.devices().size(), 3U);
}

TEST_F(DeviceHubTest, ACapAtRestTellsThatItIsStillThere) {
  const auto cable = ports_->plug({"/dev/hidraw3", "", "Cap", "", 0x256f, 0xc635, 1, 8});
  const auto cap = inPhase("256f:c635", DevicePhase::kReady);
  cable->say({3, 1, 0});
  DeviceState state;
  ASSERT_TRUE(eventually([&] { return cap->pollState(state); }));
  const std::int64_t first_ns = state.time_ns;
  ASSERT_TRUE(eventually([&] { return cap->pollState(state) && state.time_ns > first_ns; }));
  EXPECT_EQ(state.buttons, 1U);
  EXPECT_EQ(cap->counters().reports, 1U);
}

TEST_F(DeviceHubTest, NothingIsSentBeforeTheFirstPush) {
  const auto cable = ports_->plug(kArm);
  stream(cable);
  inPhase("16c0:0486/7", DevicePhase::kStreaming);
  std::this_thread::sleep_for(50ms);
  EXPECT_TRUE(cable->heard().empty());
}

TEST_F(DeviceHubTest, AForceGoesOutAndEndsWhenNobodyPushesAnyMore) {
  const auto cable = ports_->plug(kArm);
  stream(cable);
  const auto arm = inPhase("16c0:0486/7", DevicePhase::kStreaming);
  const auto begin = std::chrono::steady_clock::now();
  arm->push({{0, 0, 1000}, {}});  // far above 5 N
  ASSERT_TRUE(eventually([&] { return !cable->heard().empty() && !isZero(cable->heard().back()); }));
  const Bytes sent = cable->heard().back();
  ASSERT_EQ(sent.size(), 15U);
  for (int motor = 0; motor < 3; ++motor) {
    const int current = signedValue(bitsAt(std::span(sent).subspan(1), 16 * motor, 16), 16);
    EXPECT_LE(std::abs(current), 2000) << motor;
  }
  ASSERT_TRUE(eventually([&] { return isZero(cable->heard().back()); }));
  EXPECT_GE(std::chrono::steady_clock::now() - begin, 100ms);
}

TEST_F(DeviceHubTest, UnpluggedInContactNothingOfTheForceIsLeftForTheNextHand) {
  const auto cable = ports_->plug(kArm);
  stream(cable);
  const auto arm = inPhase("16c0:0486/7", DevicePhase::kStreaming);
  arm->push({{0, 0, 3}, {}});
  ASSERT_TRUE(eventually([&] { return !cable->heard().empty(); }));
  ports_->unplug("/dev/hidraw0");
  arm->push({{0, 0, 3}, {}});
  inPhase("16c0:0486/7", DevicePhase::kLost);
  arm->push({{0, 0, 3}, {}});
  const auto again = ports_->plug(kArm);
  inPhase("16c0:0486/7", DevicePhase::kReady);
  stream(again);
  inPhase("16c0:0486/7", DevicePhase::kStreaming);
  std::this_thread::sleep_for(50ms);
  EXPECT_TRUE(again->heard().empty());
}

TEST_F(DeviceHubTest, AnArmThatFallsSilentIsLostGetsNoForceAndComesBack) {
  const auto cable = ports_->plug(kArm);
  stream(cable);
  const auto arm = inPhase("16c0:0486/7", DevicePhase::kStreaming);
  std::jthread servo([&](const std::stop_token& stop) {
    for (; !stop.stop_requested(); std::this_thread::sleep_for(1ms)) arm->push({{0, 0, 3}, {}});
  });
  ASSERT_TRUE(eventually([&] { return !cable->heard().empty() && !isZero(cable->heard().back()); }));
  talker_ = {};
  inPhase("16c0:0486/7", DevicePhase::kLost);
  EXPECT_THAT(arm->error(), HasSubstr("no longer sends"));
  EXPECT_TRUE(isZero(cable->heard().back()));
  stream(cable);
  inPhase("16c0:0486/7", DevicePhase::kStreaming);
  ASSERT_TRUE(eventually([&] { return !isZero(cable->heard().back()); }));
}

TEST_F(DeviceHubTest, AWriteThatHangsIsToldAndHoldsUpNobody) {
  const auto cable = ports_->plug(kArm);
  stream(cable);
  const auto arm = inPhase("16c0:0486/7", DevicePhase::kStreaming);
  cable->slow(400ms);
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 100; ++i) arm->push({{0, 0, 1}, {}});
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 4s);  // not a hundred times as long as one takes
  ASSERT_TRUE(eventually([&] { return arm->error().find("no longer accepts forces") != std::string::npos; }));
  cable->slow(0ms);
  inPhase("16c0:0486/7", DevicePhase::kStreaming);
  EXPECT_GE(arm->counters().lateForces, 1U);
}

TEST_F(DeviceHubTest, ReportsThatAreNotUnderstoodAreTold) {
  const auto cable = ports_->plug(kArm);
  inPhase("16c0:0486/7", DevicePhase::kReady);
  hub_.takeEvents();
  cable->say({1, 2, 3});
  std::vector<DeviceEvent> events;
  ASSERT_TRUE(eventually([&] { return !(events = hub_.takeEvents()).empty(); }));
  EXPECT_TRUE(events[0].error);
  EXPECT_THAT(events[0].text, HasSubstr("1 report was ignored, because length or kind"));
  EXPECT_EQ(device("16c0:0486/7")->counters().refused, 1U);
  EXPECT_EQ(device("16c0:0486/7")->phase(), DevicePhase::kReady);
}

TEST_F(DeviceHubTest, TheLastThingADeviceHearsIsZero) {
  std::shared_ptr<FakeCable> cable;
  std::shared_ptr<HapticDevice> arm;
  {
    const auto ports = std::make_shared<FakePorts>();
    DeviceHub hub(std::make_unique<FakeBus>(ports));
    cable = ports->plug(kArm);
    hub.scanOnce();
    arm = hub.devices().at(0);
    cable->say(armReport(0));
    cable->say(armReport(5));
    ASSERT_TRUE(eventually([&] { return arm->phase() == DevicePhase::kStreaming; }));
    arm->push({{0, 3, 1}, {}});
    ASSERT_TRUE(eventually([&] { return !cable->heard().empty() && !isZero(cable->heard().back()); }));
  }
  EXPECT_TRUE(isZero(cable->heard().back()));
  EXPECT_EQ(arm->phase(), DevicePhase::kAbsent);  // whoever holds it still
  arm->push({});
}

}  // namespace
