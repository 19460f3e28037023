#pragma once

#include "ArmKinematics.h"

#include <insonate/haptics/DeviceState.h>
#include <insonate/haptics/DeviceTable.h>
#include <insonate/haptics/Force.h>
#include <insonate/haptics/ReportDecoder.h>

#include <optional>

namespace insonate::haptics {

/// Converts a device's reports to a pose, and forces to commands for its motors. Allocates nothing.
class StateMaker {
 public:
  /// Speed of a fully pressed cap; the first 5 % have no effect, so that a hand resting on it does not drift.
  static constexpr double kCapSpeed_mmps = 80, kCapTurn_radps = 1, kCapRest = 0.05;
  /// A cap that was silent for this long has been released.
  static constexpr std::int64_t kCapSilence_ns = 250'000'000;

  /// `table` outlives the maker.
  explicit StateMaker(const DeviceTable& table);

  /// `reported_ns`: when the last report came; `now_ns` does not run backwards.
  DeviceState make(const DeviceReading& reading, std::int64_t reported_ns, std::int64_t now_ns) noexcept;
  DeviceOutput outputFor(const Force& force, const DeviceReading& reading) const noexcept;
  /// The posture of `reading` is the home posture.
  void calibrate(const DeviceReading& reading) noexcept { home_ = reading.encoder; }
  void reset() noexcept;

 private:
  std::array<double, 3> anglesOf(const DeviceReading& reading) const noexcept;
  void moveByCap(const DeviceReading& reading, std::int64_t reported_ns, std::int64_t now_ns) noexcept;

  const DeviceTable& table_;
  std::optional<ArmKinematics> arm_;
  bool byCap_ = false;
  std::array<double, 6> home_{};
  DeviceState state_;
};

}  // namespace insonate::haptics
