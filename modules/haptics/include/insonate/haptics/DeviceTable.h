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
  kForce,   ///< a hand that is pressed back
  kMotion,  ///< a hand without forces
  kPedal,   ///< buttons only
};

std::string_view nameOf(DeviceKind kind);

/// Meaning of a field of a report. Units are those of the value times the field's scale.
enum class Quantity : std::uint8_t {
  kEncoder,     ///< counts; index 0..5
  kPosition,    ///< mm in the device's frame; index 0..2
  kQuaternion,  ///< w, x, y, z
  kDeflection,  ///< of a spring-loaded cap, -1..1; index 0..2 along x, y, z, 3..5 about them
  kButtons,     ///< one bit each; index is the first one's number
  kKey,         ///< pressed where one of `count` fields equals `usage`; index is the button's number
  kStatus,      ///< bits of the device's own
  kSequence,    ///< counts reports
  kTime,        ///< s on the device's clock
  kForce,       ///< N in the device's frame, out; index 0..2
  kTorque,      ///< N mm, out; index 0..2
  kCurrent,     ///< mA of a motor, out; index 0..2
};

/// Bits of a report, least significant first, as HID packs them. Bit 0 is the first after the report's id.
struct ReportField {
  Quantity quantity = Quantity::kStatus;
  int index = 0;
  int bit = 0, bits = 8;     ///< 1..32 bits
  bool isSigned = false;     ///< two's complement
  bool wraps = false;        ///< a counter that runs over: told as the way since the first report
  double scale = 1;          ///< unit for one count
  int count = 1, usage = 0;  ///< of kKey
};

struct ReportLayout {
  int id = 0;          ///< 0 where the device numbers no reports; then no byte holds it
  int bytes = 0;       ///< after the id; a report must have as many
  bool exact = false;  ///< and no more
  std::vector<ReportField> fields;
};

/// USB or Bluetooth devices that a table describes. Fields that are not set match all.
struct DeviceMatch {
  std::uint16_t vendor = 0, product = 0;
  std::optional<std::uint16_t> usagePage, usage;
  std::string name;  ///< a part of the device's USB product string, in any case; for controllers that share an id
};

/// Three motors and three bodies: a turret, and on it two bars whose angles are each measured against the vertical.
struct ArmTable {
  std::array<double, 3> length_mm{};              ///< height of the turret, upper bar, lower bar
  std::array<double, 3> countsPerTurn{};          ///< of the motor
  std::array<double, 3> bodyTurnsPerMotorTurn{};  ///< with sign; the cable's reduction
  std::array<double, 3> torque_NmmPermA{};        ///< of the motor
  std::array<double, 3> homeAngle_deg{};          ///< of the bodies where the device is calibrated
  Vec3 centre_mm;                                 ///< of the workspace, in the arm's own frame
  double mostCurrent_mA = 0;                      ///< through any motor
};

/// A kind of device as data: who it is and what its reports mean.
struct DeviceTable {
  std::string name;
  DeviceKind kind = DeviceKind::kMotion;
  std::string source;  ///< where the layout is known from
  std::vector<DeviceMatch> matches;
  std::vector<ReportLayout> input;
  std::optional<ReportLayout> output;
  std::optional<ArmTable> arm;
  DeviceLimits limits;
};

/// Reads a table. Refuses, with the field's name: unknown or missing fields, numbers out of range, fields that overlap
/// the end of their report, forces without an output report.
Result<DeviceTable> parseDeviceTable(std::string_view json);

/// The tables of resources/haptics/devices.
const std::vector<DeviceTable>& builtInDeviceTables();

}  // namespace insonate
