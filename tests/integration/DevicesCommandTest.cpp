#include "CommandLine.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace insonate::test {
namespace {

using testing::HasSubstr;

/// Devices are those of umockdev's making: none, or what `description` says.
CommandResult runAmong(const std::string& description, const std::string& arguments) {
  const std::string errors = testing::TempDir() + "devices_cli.err", file = testing::TempDir() + "devices_cli.umockdev";
  std::string prefix = UMOCKDEV_RUN " ";
  if (!description.empty()) {
    std::ofstream(file) << description;
    prefix += "--device " + shellWord(file) + " ";
  }
  return runCommand("devices " + arguments, errors, prefix + "-- ");
}

/// A pedal as /sys has it, without the answers of a real /dev/hidraw0.
constexpr const char* kPedal =
    "P: /devices/usb1/1-1\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nA: product=Pedal\\n\nA: serial=\\n\nA: "
    "manufacturer=VEC\\n\nA: bcdDevice=0100\\n\n\n"
    "P: /devices/usb1/1-1/1-1:1.0\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\nA: bInterfaceNumber=00\\n\n\n"
    "P: /devices/usb1/1-1/1-1:1.0/0003:1\nE: SUBSYSTEM=hid\nA: "
    "uevent=HID_ID=0003:000005F3:000000FF\\nHID_NAME=Pedal\\nHID_UNIQ=\\n\n\n"
    "P: /devices/usb1/1-1/1-1:1.0/0003:1/hidraw/hidraw0\nN: hidraw0\nE: SUBSYSTEM=hidraw\nE: DEVNAME=/dev/hidraw0\n";

class DevicesCommand : public testing::Test {
 protected:
  void SetUp() override {
    if (!*UMOCKDEV_RUN) GTEST_SKIP() << "umockdev is not installed: packaging/dependencies";
  }
};

TEST_F(DevicesCommand, WithoutDevicesItNamesThoseItKnows) {
  const CommandResult run = runAmong("", "--seconds 0.1");
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("No device that Insonate supports is plugged in."));
  EXPECT_THAT(run.output, HasSubstr("SpaceMouse"));
  const auto json = nlohmann::json::parse(runAmong("", "--seconds 0.1 --json").output);
  EXPECT_TRUE(json.at("devices").empty());
  EXPECT_TRUE(json.at("version").is_string());
}

TEST_F(DevicesCommand, ADeviceThatCannotBeUsedIsListedWithTheReason) {
  const auto json = nlohmann::json::parse(runAmong(kPedal, "--seconds 0.2 --json").output);
  ASSERT_EQ(json.at("devices").size(), 1U);
  const auto& device = json["devices"][0];
  EXPECT_EQ(device["id"], "05f3:00ff");
  EXPECT_EQ(device["kind"], "pedal");
  EXPECT_EQ(device["phase"], "failed");
  EXPECT_THAT(device["trouble"].get<std::string>(), HasSubstr("/dev/hidraw0 cannot be opened"));
  EXPECT_EQ(device["limits"]["sensed_axes"], 0);
  bool told = false;
  for (const auto& event : json["events"]) told |= event["trouble"].get<bool>();
  EXPECT_TRUE(told);
}

TEST_F(DevicesCommand, ARecordingThatCannotBeWrittenIsRefused) {
  const CommandResult run = runAmong("", "--record /nowhere/at.all --json");
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.output, HasSubstr("/nowhere/at.all cannot be written"));
}

}  // namespace
}  // namespace insonate::test
