#pragma once

#include "ArmKinematics.h"

#include <insonate/haptics/DeviceState.h>
#include <insonate/haptics/DeviceTable.h>
#include <insonate/haptics/Force.h>
#include <insonate/haptics/ReportDecoder.h>

#include <optional>

namespace insonate::haptics {

/// Converts the decoded reports of a device to the stylus's pose, and forces to motor commands. Allocates nothing.
class StateMaker {
 public:
  /// Speeds of the tool at full deflection of a 3D mouse's cap, and the fraction of the deflection without effect, so
  /// that a resting hand causes no drift.
  static constexpr double kCapSpeed_mmps = 80, kCapTurn_radps = 1, kCapRest = 0.05;
  /// Time without reports after which a 3D mouse's cap counts as released.
  static constexpr std::int64_t kCapSilence_ns = 250'000'000;

  /// `table` must outlive the maker.
  explicit StateMaker(const DeviceTable& table);

  /// Computes the device's state at `now_ns`, which must not decrease. `reported_ns`: time of the last report.
  DeviceState make(const DeviceReading& reading, std::int64_t reported_ns, std::int64_t now_ns) noexcept;
  DeviceOutput outputFor(const Force& force, const DeviceReading& reading) const noexcept;
  /// Declares that the encoder counts of `reading` belong to the home posture.
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
