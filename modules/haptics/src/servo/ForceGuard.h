#pragma once

#include <insonate/haptics/Force.h>

#include <cstdint>

namespace insonate::haptics {

/// Limits of every force, whatever the model demands.
struct GuardLimits {
  double force_N = 0;      ///< length of the force
  double torque_Nmm = 0;   ///< length of the torque
  double slew_Npms = 0.5;  ///< most that the force may change in a millisecond
  double silence_ms = 50;  ///< without news for so long, forces begin to fall ...
  double fall_ms = 40;     ///< ... and are gone after so much more; together below 100
};

/// The last stage of a force before a device: limits its magnitude and rate of change, and reduces it to zero when its
/// inputs stop arriving. For one hand; a force that is not finite counts as none.
class ForceGuard {
 public:
  explicit ForceGuard(const GuardLimits& limits = {}) : limits_(limits) {}

  void setLimits(const GuardLimits& limits) { limits_ = limits; }
  const GuardLimits& limits() const { return limits_; }

  /// `silent_ns`: since the older of the last states and the last local model; `step_ns`: since the last call.
  Force pass(const Force& wanted, std::int64_t silent_ns, std::int64_t step_ns) noexcept;
  const Force& last() const { return last_; }
  /// The device is gone: no force, at once.
  void reset() { last_ = {}; }

 private:
  GuardLimits limits_;
  Force last_;
};

}  // namespace insonate::haptics
