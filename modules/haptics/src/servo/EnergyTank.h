#pragma once

#include <insonate/haptics/Force.h>

#include <optional>

namespace insonate::haptics {

/// Position and rotation of a stylus, from which EnergyTank computes energies.
struct StylusPlace {
  Vec3 position_mm;
  Vec3 turned_rad;  ///< rotation vector since the last tick; used for devices with torque
  /// Energy that the hand has put in since the last tick, N mm; empty: the energy is computed from force and path.
  std::optional<double> given_mJ;
};

/// Properties of the device for EnergyTank, which takes the energy that the device's own mechanics dissipate into
/// account.
struct TankLimits {
  double max_J = 0.05;       ///< maximum of the energy that the account stores
  double friction_N = 0;     ///< friction of the device's mechanics
  double damping_Nspmm = 0;  ///< damping of the device's mechanics
  double resolution_mm = 0;  ///< smallest position change that the encoders report
  double mass_kg = 0.05;     ///< minimum mass that the device's force has to move
};

/// Passivity control of one tool: measures the energy that the user's hand puts into the virtual tissue, and limits
/// forces so that no more energy is returned. This removes the energy that sampling a spring once per millisecond
/// creates while the hand withdraws (K v^2 T / 2 per second), and the energy that an encoder's steps hide. The method
/// is a passivity observer and controller (Hannaford and Ryu, IEEE Trans Robot Autom 2002;18:1) that computes one tick
/// ahead: a force is limited to the energy that the account could provide if the stylus followed the force. A force
/// against a motion that cannot reverse within a tick is not limited.
class EnergyTank {
 public:
  void setLimits(const TankLimits& limits) { limits_ = limits; }
  void reset();
  /// Updates the account with the stylus's new `place`, which was reached under the force that was returned last.
  /// Returns the new force, limited if necessary. `free_N`: part of `wanted` that needs no limit here, since another
  /// account covers this part.
  Force pass(const Force& wanted, Vec3 free_N, const StylusPlace& place, double step_s) noexcept;
  double energy_J() const { return energy_mJ_ * 1e-3; }

 private:
  void account(const StylusPlace& place, Vec3 moved_mm, double step_s);

  TankLimits limits_;
  bool started_ = false;
  double energy_mJ_ = 0;  // stored energy, N mm
  double share_ = 1;      // fraction of the non-resisting force that was returned in the last tick
  Vec3 position_mm_, dragged_mm_, free_N_, before_N_;
  Force last_;
};

}  // namespace insonate::haptics
