#include "servo/EnergyTank.h"

#include <algorithm>
#include <cmath>

namespace insonate::haptics {
namespace {

/// Share of a step that may lie at a right angle to its expected direction.
constexpr double kAcross = 0.25;
/// In one tick.
constexpr double kRise = 0.05;
/// Half the diagonal of a cube, in units of its side.
constexpr double kHalfDiagonal = 0.87;

}  // namespace

void EnergyTank::reset() {
  started_ = false;
  energy_mJ_ = 0;
  share_ = 1;
  free_N_ = before_N_ = {};
  last_ = {};
}

void EnergyTank::account(const StylusPlace& place, Vec3 moved_mm, double step_s) {
  energy_mJ_ +=
      place.given_mJ.value_or(-dot(last_.force_N - free_N_, moved_mm) - dot(last_.torque_Nmm, place.turned_rad));
  // The position of the stylus is known to half a step. By summation by parts, the error of the work is at most this
  // much for each change of the force.
  energy_mJ_ -= norm(last_.force_N - free_N_ - before_N_) * limits_.resolution_mm * kHalfDiagonal;
  before_N_ = last_.force_N - free_N_;
  // An encoder that alternates between two steps is no motion: only motion beyond the play counts.
  const double play_mm = 2 * kHalfDiagonal * limits_.resolution_mm;
  const Vec3 away = place.position_mm - dragged_mm_;
  if (const double far_mm = norm(away); far_mm > play_mm) {
    const double way_mm = far_mm - play_mm;
    dragged_mm_ = dragged_mm_ + away * (way_mm / far_mm);
    if (step_s > 0) energy_mJ_ += way_mm * (limits_.friction_N + limits_.damping_Nspmm * way_mm / step_s);
  }
  energy_mJ_ = std::min(energy_mJ_, limits_.max_J * 1e3);
}

Force EnergyTank::pass(const Force& wanted, Vec3 free_N, const StylusPlace& place, double step_s) noexcept {
  const Vec3 moved_mm = started_ ? place.position_mm - position_mm_ : Vec3{};
  if (started_)
    account(place, moved_mm, step_s);
  else
    dragged_mm_ = place.position_mm;
  started_ = true;
  position_mm_ = place.position_mm;
  free_N_ = free_N;
  last_ = wanted;
  // Without a force no spring holds energy: the rest was dissipated and must not pay for later forces.
  if (wanted.force_N == free_N && wanted.torque_Nmm == Vec3{}) {
    energy_mJ_ = 0;
    share_ = 1;
    dragged_mm_ = place.position_mm;
    return last_;
  }
  const Vec3 own_N = wanted.force_N - free_N;
  const double way_mm = norm(moved_mm);
  // Uncertainty of the stylus's position after a tick: motion below the encoders' resolution, or caused by the force.
  const double unsure_mm = limits_.resolution_mm + norm(own_N) * step_s * step_s * 1e3 / limits_.mass_kg;
  const Vec3 direction = way_mm > 0 ? moved_mm / way_mm : Vec3{};
  const double along_N = dot(own_N, direction);
  const bool resists = way_mm > 2 * unsure_mm && along_N < 0;
  const Vec3 resisting_N = resists ? direction * along_N : Vec3{};
  const Vec3 across_N = own_N - direction * along_N;
  const double may_mJ = std::max(0.0, energy_mJ_);
  const double risks_mJ = (resists ? 0 : std::abs(along_N) * (way_mm + unsure_mm)) +
                          norm(across_N) * (kAcross * way_mm + unsure_mm) +
                          norm(wanted.torque_Nmm) * (norm(place.turned_rad) + 0.001);
  // Decreases at once and increases slowly: each change of a force that comes and goes would cost the account the error
  // of the encoder's steps.
  share_ = std::min(share_ + kRise, risks_mJ > may_mJ ? may_mJ / risks_mJ : 1);
  last_.force_N = free_N + resisting_N + (own_N - resisting_N) * share_;
  last_.torque_Nmm = wanted.torque_Nmm * share_;
  return last_;
}

}  // namespace insonate::haptics
