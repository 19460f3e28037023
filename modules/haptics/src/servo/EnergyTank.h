#pragma once

#include <insonate/haptics/Force.h>

#include <optional>

namespace insonate::haptics {

/// Position and rotation of a stylus, for the energy account.
struct StylusPlace {
  Vec3 position_mm;
  Vec3 turned_rad;  ///< rotation since the last tick, for devices that render torque
  /// Energy added since the last tick, N mm; set if it is known more exactly than from force and path.
  std::optional<double> given_mJ;
};

/// Known properties of the device. The account may count on the energy that the device's mechanics dissipate, but on no
/// other dissipation.
struct TankLimits {
  double max_J = 0.05;       ///< maximum of the stored energy
  double friction_N = 0;     ///< friction of the device
  double damping_Nspmm = 0;  ///< damping of the device
  double resolution_mm = 0;  ///< resolution of the device's position
  double mass_kg = 0.05;     ///< minimum mass that the force has to move
};

/// Keeps account of the energy that a hand puts into its surroundings, and returns no more than that. It removes the
/// energy that sampling a spring once per millisecond creates while the hand withdraws (K v^2 T / 2 per second), and
/// the energy that an encoder's steps hide. It is a passivity observer and controller (Hannaford and Ryu, IEEE Trans
/// Robot Autom 2002;18:1) that looks one tick ahead: a force is limited to the energy that the account could provide if
/// the stylus followed the force. A force against a motion that cannot reverse within a tick is not limited.
class EnergyTank {
 public:
  void setLimits(const TankLimits& limits) { limits_ = limits; }
  void reset();
  /// Updates the account with the stylus's new `place`, reached under the force that was returned last, and returns the
  /// new force. `free_N`: part of `wanted` that another account covers.
  Force pass(const Force& wanted, Vec3 free_N, const StylusPlace& place, double step_s) noexcept;
  double energy_J() const { return energy_mJ_ * 1e-3; }

 private:
  void account(const StylusPlace& place, Vec3 moved_mm, double step_s);

  TankLimits limits_;
  bool started_ = false;
  double energy_mJ_ = 0;  // N mm
  double share_ = 1;      // share of the non-resisting force that was passed in the last tick
  Vec3 position_mm_, dragged_mm_, free_N_, before_N_;
  Force last_;
};

}  // namespace insonate::haptics
