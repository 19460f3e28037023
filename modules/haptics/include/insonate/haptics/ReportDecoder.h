#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/haptics/DeviceTable.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace insonate {

/// State from all reports received so far: if a device splits its axes over several reports, a report changes only its
/// own axes.
struct DeviceReading {
  std::array<double, 6> encoder{};               ///< counts; counters that overflow: since the first report
  std::optional<Vec3> position_mm;               ///< device frame (DeviceState.h)
  std::array<double, 4> quaternion{1, 0, 0, 0};  ///< w, x, y, z as reported, not normalized
  std::array<double, 6> deflection{};            ///< -1..1: along x, y, z, then about them
  std::uint32_t buttons = 0;
  std::uint32_t status = 0;
  std::uint32_t sequence = 0;
  double time_s = 0;  ///< on the device's clock
};

/// Outcome of decoding one report.
enum class ReportFate : std::uint8_t {
  kTaken,
  kShort,    ///< fewer bytes than any layout of its id
  kLong,     ///< more than an exact layout allows
  kUnknown,  ///< an id without a layout, or an empty report
};

/// Decodes reports by a table. Neither allocates nor throws. For one device and one thread.
class ReportDecoder {
 public:
  /// `table` must outlive the decoder.
  explicit ReportDecoder(const DeviceTable& table);

  /// Decodes a report as hidapi reads it: the report begins with its id only if the device numbers its reports. Of
  /// several layouts with this id, the longest that fits is used; further bytes are padding. A report that is rejected
  /// changes nothing.
  ReportFate take(std::span<const std::uint8_t> report) noexcept;
  const DeviceReading& reading() const noexcept { return reading_; }
  /// Resets the decoder after the device was plugged in again: counters start at zero, and no button is pressed.
  void reset() noexcept;

 private:
  struct Counter {
    bool known = false;
    std::uint32_t last = 0;
    std::int64_t way = 0;
  };

  const ReportLayout* layoutOf(int id, std::size_t bytes, ReportFate& fate) const noexcept;
  double valueOf(const ReportField& field, std::uint32_t raw) noexcept;
  void apply(const ReportField& field, std::span<const std::uint8_t> payload) noexcept;

  const DeviceTable& table_;
  bool numbered_ = false;
  DeviceReading reading_;
  std::array<Counter, 6> counters_{};
};

/// Returns `bits` bits, beginning at `bit`, least significant first; bits beyond the end of `bytes` are 0.
std::uint32_t bitsAt(std::span<const std::uint8_t> bytes, int bit, int bits) noexcept;
/// Reads the lower `bits` bits as a two's complement number.
std::int32_t signedValue(std::uint32_t raw, int bits) noexcept;

/// Output to a device.
struct DeviceOutput {
  Vec3 force_N, torque_Nmm;            ///< device frame
  std::array<double, 3> current_mA{};  ///< for each motor
  std::uint32_t sequence = 0;
};

/// Writes `output` by `layout` into `report`, the id first, as hidapi expects it (0 if reports have none). Numbers are
/// rounded to the nearest count and clamped to the field's range; numbers that are not finite become 0. Returns the
/// bytes used, 0 if `report` is too small.
std::size_t encodeReport(const ReportLayout& layout, const DeviceOutput& output,
                         std::span<std::uint8_t> report) noexcept;

}  // namespace insonate
