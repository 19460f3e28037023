#pragma once

#include <insonate/core/Result.h>
#include <insonate/core/Vec3.h>
#include <insonate/haptics/DeviceLimits.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Purpose of a device.
enum class DeviceKind : std::uint8_t {
  kForce,   ///< tool for a hand, with force feedback
  kMotion,  ///< tool for a hand, without force feedback
  kPedal,   ///< buttons only
};

std::string_view nameOf(DeviceKind kind);

/// Meaning of a field of a report. The unit is that of the raw value times the field's scale.
enum class Quantity : std::uint8_t {
  kEncoder,     ///< counts; index 0..5
  kPosition,    ///< mm in the device's frame; index 0..2
  kQuaternion,  ///< w, x, y, z
  kDeflection,  ///< deflection of a spring-loaded cap, -1..1; index 0..2: along x, y, z; 3..5: about them
  kButtons,     ///< one bit per button; index is the number of the first button
  kKey,         ///< a button, pressed if one of `count` fields equals `usage`; index is the button's number
  kStatus,      ///< device-specific bits
  kSequence,    ///< number of the report
  kTime,        ///< s, on the device's clock
  kForce,       ///< output: N in the device's frame; index 0..2
  kTorque,      ///< output: N mm; index 0..2
  kCurrent,     ///< output: mA of a motor; index 0..2
};

/// Bits of a report, least significant first, as HID packs them. Bit 0 is the first bit after the report's id.
struct ReportField {
  Quantity quantity = Quantity::kStatus;
  int index = 0;
  int bit = 0, bits = 8;     ///< 1..32 bits wide
  bool isSigned = false;     ///< two's complement
  bool wraps = false;        ///< a counter that overflows: its value is the change since the first report
  double scale = 1;          ///< unit for one count
  int count = 1, usage = 0;  ///< for kKey
};

struct ReportLayout {
  int id = 0;          ///< 0: the device does not number its reports, and they have no byte for the id
  int bytes = 0;       ///< minimum length after the id
  bool exact = false;  ///< longer reports are rejected
  std::vector<ReportField> fields;
};

/// USB or Bluetooth devices that a table describes. Fields that are not set match every device.
struct DeviceMatch {
  std::uint16_t vendor = 0, product = 0;
  std::optional<std::uint16_t> usagePage, usage;
  std::string name;  ///< part of the device's USB product string, ignoring case; for controllers that share an id
};

/// Arm with three motors and three bodies: a turret, and on it two bars, whose angles are each measured from the
/// vertical.
struct ArmTable {
  std::array<double, 3> length_mm{};              ///< height of the turret, upper bar, lower bar
  std::array<double, 3> countsPerTurn{};          ///< for each motor
  std::array<double, 3> bodyTurnsPerMotorTurn{};  ///< gear ratio of the cable drive, with sign
  std::array<double, 3> torque_NmmPermA{};        ///< for each motor
  std::array<double, 3> homeAngle_deg{};          ///< angles of the bodies in the home posture
  Vec3 centre_mm;                                 ///< center of the workspace, in the arm's own frame
  double mostCurrent_mA = 0;                      ///< maximum current of each motor
};

/// A kind of device, as data: how it is recognized and what its reports mean.
struct DeviceTable {
  std::string name;
  DeviceKind kind = DeviceKind::kMotion;
  std::string source;  ///< source of the report layout
  std::vector<DeviceMatch> matches;
  std::vector<ReportLayout> input;
  std::optional<ReportLayout> output;
  std::optional<ArmTable> arm;
  DeviceLimits limits;
};

/// Parses a table. Fails, with the field's name, on unknown or missing fields, numbers out of range, fields that extend
/// beyond the end of their report, and forces without an output report.
Result<DeviceTable> parseDeviceTable(std::string_view json);

/// Returns the tables of resources/haptics/devices.
const std::vector<DeviceTable>& builtInDeviceTables();

}  // namespace insonate
