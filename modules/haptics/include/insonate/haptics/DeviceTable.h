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

/// Purpose of an input device.
enum class DeviceKind : std::uint8_t {
  kForce,   ///< hand-held stylus with force feedback
  kMotion,  ///< hand-held controller without force feedback
  kPedal,   ///< pedal, which has only buttons
  // The following devices have no table.
  kCamera,      ///< body that a camera follows
  kTracker,     ///< marker or sensor that a tracking system follows
  kController,  ///< game controller
};

std::string_view nameOf(DeviceKind kind);

/// Quantity that a field of a HID report contains. The unit stated for each quantity is the unit of the raw value times
/// ReportField::scale.
enum class Quantity : std::uint8_t {
  kEncoder,     ///< encoder counts; index 0 to 5 selects the joint
  kPosition,    ///< position, mm, device frame; index 0 to 2: x, y, z
  kQuaternion,  ///< attitude as a quaternion; index 0 to 3: w, x, y, z
  kDeflection,  ///< deflection of a 3D mouse's spring-loaded cap, -1 to 1; index 0 to 2: along x, y, z; 3 to 5: about
                ///< x, y, z
  kButtons,     ///< one bit per button; index: number of the button in the lowest bit
  /// a single button; the button is pressed if one of ReportField::count consecutive fields equals ReportField::usage;
  /// index: number of the button
  kKey,
  kStatus,    ///< status bits whose meaning is specific to the device
  kSequence,  ///< sequence number of the report
  kTime,      ///< time in s on the device's own clock
  kForce,     ///< output: force in N, device frame; index 0 to 2: x, y, z
  kTorque,    ///< output: torque in N mm, device frame; index 0 to 2: about x, y, z
  kCurrent,   ///< output: motor current in mA; index 0 to 2 selects the motor
};

/// One field of a HID report: a run of bits, least significant first, and its meaning. Bit 0 is the first bit after the
/// report's id.
struct ReportField {
  Quantity quantity = Quantity::kStatus;
  int index = 0;
  int bit = 0, bits = 8;  ///< first bit of the field, and its width in bits (1 to 32)
  bool isSigned = false;  ///< true: the raw value is a two's complement number
  /// true: the raw value is a counter that overflows; the decoded value is the change since the first report
  bool wraps = false;
  double scale = 1;          ///< factor from the raw value to the unit of `quantity`
  int count = 1, usage = 0;  ///< only for Quantity::kKey: number of consecutive fields, and the HID usage code that one
                             ///< of them has if the button is pressed
};

/// Layout of one kind of HID report: its id, length and fields.
struct ReportLayout {
  int id = 0;          ///< HID report id; 0: the device does not number its reports, and they have no id byte
  int bytes = 0;       ///< minimum report length in bytes, without the id byte
  bool exact = false;  ///< true: reports longer than `bytes` are rejected
  std::vector<ReportField> fields;
};

/// Criterion by which the program recognizes the USB or Bluetooth devices that a device table describes. A field
/// without a value, or an empty name, matches every device.
struct DeviceMatch {
  std::uint16_t vendor = 0, product = 0;
  std::optional<std::uint16_t> usagePage, usage;
  /// text that the USB product string must contain, ignoring case; distinguishes devices with equal USB ids
  std::string name;
};

/// Geometry and motors of a three-axis haptic arm: a turret that carries two bars. Each bar's angle is measured from
/// the vertical.
struct ArmTable {
  std::array<double, 3> length_mm{};              ///< lengths: height of the turret, upper bar, lower bar
  std::array<double, 3> countsPerTurn{};          ///< encoder counts per turn of each motor
  std::array<double, 3> bodyTurnsPerMotorTurn{};  ///< gear ratio of each cable drive, with sign: turns of the turret
                                                  ///< or the bar per turn of the motor
  std::array<double, 3> torque_NmmPermA{};        ///< torque per current of each motor
  /// angles of turret, upper and lower bar in the home posture, from which the encoders count
  std::array<double, 3> homeAngle_deg{};
  Vec3 center_mm;            ///< center of the workspace, in the arm frame
  double maxCurrent_mA = 0;  ///< maximum current of each motor
};

/// Description of one device model as data: the criteria that identify it, the layout of its reports, and its limits.
struct DeviceTable {
  std::string name;
  DeviceKind kind = DeviceKind::kMotion;
  std::string source;  ///< publication or driver from which the report layout was taken
  std::vector<DeviceMatch> matches;
  std::vector<ReportLayout> input;
  std::optional<ReportLayout> output;
  std::optional<ArmTable> arm;
  DeviceLimits limits;
};

/// Parses a device table. Fails, naming the field, on unknown or missing fields, numbers out of range, report fields
/// beyond the end of their report, and a force device without an output report.
Result<DeviceTable> parseDeviceTable(std::string_view json);

/// Returns the built-in device tables, which are in resources/haptics/devices.
const std::vector<DeviceTable>& builtInDeviceTables();

}  // namespace insonate
