#pragma once

#include <insonate/haptics/Force.h>

#include <cstdint>

namespace insonate::haptics {

/// Limits of every force, whatever the model requests.
struct GuardLimits {
  double force_N = 0;      ///< maximum magnitude of the force
  double torque_Nmm = 0;   ///< maximum magnitude of the torque
  double slew_Npms = 0.5;  ///< maximum change of the force per millisecond
  double silence_ms = 50;  ///< time without input after which forces begin to fall
  double fall_ms = 40;     ///< time in which forces then fall to zero; together below 100 ms
};

/// Last stage before a device: limits a force's magnitude and rate of change, and reduces the force to zero if its
/// inputs stop arriving. For one hand; a force that is not finite counts as zero.
class ForceGuard {
 public:
  explicit ForceGuard(const GuardLimits& limits = {}) : limits_(limits) {}

  void setLimits(const GuardLimits& limits) { limits_ = limits; }
  const GuardLimits& limits() const { return limits_; }

  /// `silent_ns`: age of the last states or of the last local model, whichever is older; `step_ns`: time since the last
  /// call.
  Force pass(const Force& wanted, std::int64_t silent_ns, std::int64_t step_ns) noexcept;
  const Force& last() const { return last_; }
  /// Sets the force to zero at once, when the device is gone.
  void reset() { last_ = {}; }

 private:
  GuardLimits limits_;
  Force last_;
};

}  // namespace insonate::haptics
