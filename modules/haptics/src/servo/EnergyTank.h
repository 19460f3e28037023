#pragma once

#include <insonate/haptics/Force.h>

#include <optional>

namespace insonate::haptics {

/// State of a stylus in terms of energy.
struct StylusPlace {
  Vec3 position_mm;
  Vec3 turned_rad;  ///< since the last tick, for devices that give torque
  /// Energy added since the last tick, N mm, if it is known better than from force and path.
  std::optional<double> given_mJ;
};

/// Known properties of the device: only the energy that its own mechanics dissipate may be counted on.
struct TankLimits {
  double most_J = 0.05;      ///< that is remembered
  double friction_N = 0;     ///< of the device
  double damping_Nspmm = 0;  ///< of the device
  double resolution_mm = 0;  ///< of its position
  double mass_kg = 0.05;     ///< the least that its force has to move
};

/// Keeps account of the energy that a hand gives to its surroundings, and returns no more: the energy that a spring
/// sampled once a millisecond creates on the way out (K v^2 T / 2 a second), and that an encoder's steps hide, is
/// removed. A passivity observer and controller (Hannaford and Ryu, IEEE Trans Robot Autom 2002;18:1) that looks one
/// tick ahead: a force is limited to what the account can pay for, should the stylus follow it. Forces against a
/// motion that cannot reverse within a tick are not limited.
class EnergyTank {
 public:
  void setLimits(const TankLimits& limits) { limits_ = limits; }
  void reset();
  /// The stylus has moved to `place` under the force that was last returned. `free_N` is the part of `wanted` that
  /// another account keeps.
  Force pass(const Force& wanted, Vec3 free_N, const StylusPlace& place, double step_s) noexcept;
  double energy_J() const { return energy_mJ_ * 1e-3; }

 private:
  void account(const StylusPlace& place, Vec3 moved_mm, double step_s);

  TankLimits limits_;
  bool started_ = false;
  double energy_mJ_ = 0;  // N mm
  double share_ = 1;      // of what is not resisting, in the last tick
  Vec3 position_mm_, dragged_mm_, free_N_, before_N_;
  Force last_;
};

}  // namespace insonate::haptics
