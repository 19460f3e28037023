#pragma once

#include <insonate/haptics/Force.h>

#include <optional>

namespace insonate::haptics {

/// State of a stylus in terms of energy.
struct StylusPlace {
  Vec3 position_mm;
  Vec3 turned_rad;  ///< since the last tick, for devices that give torque
  /// Energy that went in since the last tick, N mm, where it is known better than from force and way.
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

/// Keeps account of the energy that a hand gives to what it touches, and lets it have no more back: what a spring that
/// is looked at once a millisecond makes up on the way out (K v^2 T / 2 a second), and what an encoder's steps hide, is
/// taken off. A passivity observer and controller (Hannaford and Ryu, IEEE Trans Robot Autom 2002;18:1) that looks one
/// tick ahead: a force may only be as large as the account can pay for, should the stylus go its way. What stands
/// against a motion that cannot turn round within a tick is left alone.
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
