#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/haptics/DeviceTable.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace insonate {

/// Values decoded from all reports of a device so far. If a device splits its axes over several reports, each report
/// changes only the axes that it contains.
struct DeviceReading {
  std::array<double, 6> encoder{};  ///< encoder counts; for counters that overflow, the change since the first report
  std::optional<Vec3> position_mm;  ///< position of the stylus, device frame (DeviceState.h)
  std::array<double, 4> quaternion{1, 0, 0, 0};  ///< attitude w, x, y, z as reported, not normalized
  std::array<double, 6> deflection{};  ///< deflection of a 3D mouse's cap, -1 to 1: along x, y, z, then about x, y, z
  std::uint32_t buttons = 0;
  std::uint32_t status = 0;
  std::uint32_t sequence = 0;
  double time_s = 0;  ///< time on the device's own clock
};

/// Outcome of decoding one report.
enum class ReportOutcome : std::uint8_t {
  kDecoded,
  kShort,    ///< rejected: shorter than every layout with the report's id
  kLong,     ///< rejected: longer than a layout with ReportLayout::exact allows
  kUnknown,  ///< rejected: no layout has the report's id, or the report is empty
};

/// Decodes the HID reports of one device by its device table. Neither allocates nor throws. One object must be used on
/// one thread only.
class ReportDecoder {
 public:
  /// Makes a decoder for devices of one table, which must outlive the decoder.
  explicit ReportDecoder(const DeviceTable& table);

  /// Decodes a report in the form in which hidapi returns it: the first byte is the report id if the device numbers its
  /// reports. If several layouts have this id, the longest layout that fits is used; further bytes are padding. A
  /// rejected report changes nothing.
  ReportOutcome decode(std::span<const std::uint8_t> report) noexcept;
  const DeviceReading& reading() const noexcept { return reading_; }
  /// Resets the decoder after the device was plugged in again: counters start at zero, and no button is pressed.
  void reset() noexcept;

 private:
  struct Counter {
    bool known = false;
    std::uint32_t last = 0;
    std::int64_t way = 0;
  };

  const ReportLayout* layoutOf(int id, std::size_t bytes, ReportOutcome& fate) const noexcept;
  double valueOf(const ReportField& field, std::uint32_t raw) noexcept;
  void apply(const ReportField& field, std::span<const std::uint8_t> payload) noexcept;

  const DeviceTable& table_;
  bool numbered_ = false;
  DeviceReading reading_;
  std::array<Counter, 6> counters_{};
};

/// Returns the unsigned number that consists of `bits` bits, the first of which is bit `bit`, least significant bit
/// first. Bits beyond the end of `bytes` are 0.
std::uint32_t bitsAt(std::span<const std::uint8_t> bytes, int bit, int bits) noexcept;
/// Returns the value of the lower `bits` bits as a two's complement number.
std::int32_t signedValue(std::uint32_t raw, int bits) noexcept;

/// Values for an output report to a device: force and torque, or motor currents.
struct DeviceOutput {
  Vec3 force_N, torque_Nmm;            ///< force and torque in the device frame
  std::array<double, 3> current_mA{};  ///< current for each motor
  std::uint32_t sequence = 0;
};

/// Encodes `output` with `layout` into `report`. As hidapi requires, the first byte is the report id, or 0 if the
/// reports have no id. Numbers are rounded to the nearest count and clamped to the field's range; non-finite numbers
/// become 0. Returns the number of bytes used, 0 if `report` is too small.
std::size_t encodeReport(const ReportLayout& layout, const DeviceOutput& output,
                         std::span<std::uint8_t> report) noexcept;

}  // namespace insonate
