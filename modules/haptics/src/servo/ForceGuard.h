#pragma once

#include <insonate/haptics/Force.h>

#include <cstdint>

namespace insonate::haptics {

/// Limits that ForceGuard applies to every force before it is sent to a device.
struct GuardLimits {
  double force_N = 0;      ///< maximum magnitude of the force
  double torque_Nmm = 0;   ///< maximum magnitude of the torque
  double slew_Npms = 0.5;  ///< maximum change of the force per millisecond
  double silence_ms = 50;  ///< time without input after which forces begin to decrease
  double fall_ms = 40;     ///< time in which forces then decrease to zero; silence_ms + fall_ms is below 100
};

/// Last safety stage before a force is sent to a device: limits magnitude and rate of change, and reduces the force to
/// zero if device states or tissue models stop arriving. A force that is not finite counts as zero. Each device needs
/// its own object.
class ForceGuard {
 public:
  explicit ForceGuard(const GuardLimits& limits = {}) : limits_(limits) {}

  void setLimits(const GuardLimits& limits) { limits_ = limits; }
  const GuardLimits& limits() const { return limits_; }

  /// Returns `wanted` within the limits. `silent_ns`: age of the last device state or of the last LocalModel, whichever
  /// is older; `step_ns`: time since the last call.
  Force pass(const Force& wanted, std::int64_t silent_ns, std::int64_t step_ns) noexcept;
  const Force& last() const { return last_; }
  /// Sets the force to zero at once; for a device that is disconnected.
  void reset() { last_ = {}; }

 private:
  GuardLimits limits_;
  Force last_;
};

}  // namespace insonate::haptics
