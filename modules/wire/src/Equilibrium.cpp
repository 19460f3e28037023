#include "Equilibrium.h"

#include <algorithm>
#include <cmath>

namespace insonate::wire {
namespace {

constexpr double kMaxTurn_rad = 0.35;                    // of one Newton step
constexpr double kMinDamping = 1e-6, kMaxDamping = 1e8;  // N/mm; the smallest decides how fast a rod buckles
constexpr double kDampingTurn_mm2 = 4;                   // damping of rotations, relative to that of shifts
constexpr double kMomentArm_mm = 5;                      // an unbalanced moment counts by this lever
constexpr double kDecrease = 1e-4;  // share of the promised decrease of the energy that a step must reach
constexpr double kRounding = 1e-12;

}  // namespace

Equilibrium::Outcome Equilibrium::solve(Rod& rod, const RodEnergy& energy) {
  Outcome outcome;
  energy_Nmm_ = energy.energy(rod), damping_ = 0;
  while (true) {
    energy.assemble(rod, gradient_, equations_);
    outcome.unbalanced_N = 0;
    for (int j = 0; j < rod.segments; ++j)
      outcome.unbalanced_N = std::max(
          {outcome.unbalanced_N, gradient_[j].head<3>().norm(), gradient_[j].tail<3>().norm() / kMomentArm_mm});
    if (outcome.unbalanced_N < tolerance_N_ || outcome.iterations == maxIterations_) return outcome;
    ++outcome.iterations;
    if (!improve(rod, energy)) return outcome;
  }
}

bool Equilibrium::improve(Rod& rod, const RodEnergy& energy) {
  while (damping_ < kMaxDamping) {
    BlockVector shift;
    shift << Vector::Constant(damping_), Vector::Constant(damping_ * kDampingTurn_mm2);
    if (equations_.factorize(rod.segments, shift)) {
      std::copy_n(gradient_.begin(), rod.segments, change_.begin());
      equations_.solve(rod.segments, change_);
      const double expected_Nmm = applyChange(rod);
      const double trial_Nmm = energy.energy(trial_);
      if (trial_Nmm <= energy_Nmm_ - kDecrease * expected_Nmm + kRounding * std::abs(energy_Nmm_)) {
        rod.copyFrom(trial_);
        energy_Nmm_ = trial_Nmm;
        damping_ = damping_ / 10 < kMinDamping ? 0 : damping_ / 10;
        return true;
      }
    }
    damping_ = std::max(kMinDamping, damping_ * 10);
  }
  return false;
}

/// Applies the Newton step, shortened to its limits, to a copy of the rod: turns the frames, and places the nodes so
/// that stretch and shear change as the linear step says. Nodes that moved straight would stretch a rod that turns, and
/// only tiny steps would reduce the energy. Returns the decrease of the energy that the gradient promises.
double Equilibrium::applyChange(const Rod& rod) {
  double scale = 1, expected_Nmm = 0;
  for (int j = 0; j < rod.segments; ++j) {
    scale = std::min(scale, kMaxTurn_rad / std::max(change_[j].tail<3>().norm(), 1e-30));
    expected_Nmm += gradient_[j].dot(change_[j]);
  }
  trial_.copyFrom(rod);
  for (int j = rod.segments - 1; j >= 0; --j) {
    const Vector turn = -scale * change_[j].tail<3>();
    Vector shift = -scale * change_[j].head<3>();
    if (j + 1 < rod.segments) shift += scale * change_[j + 1].head<3>();
    const double angle = turn.norm(), length_mm = rod.length_mm[j];
    const Frame toBody = rod.frame[j].conjugate();
    const Vector e = toBody * Vector((rod.node[j] - rod.node[j + 1]) / length_mm);
    const Vector changed = e + toBody * Vector(shift / length_mm) - turn.cross(e);
    if (angle > 0) trial_.frame[j] = (rod.frame[j] * Frame(Eigen::AngleAxisd(angle, turn / angle))).normalized();
    trial_.node[j] = trial_.node[j + 1] + length_mm * (trial_.frame[j] * changed);
  }
  return scale * expected_Nmm;
}

}  // namespace insonate::wire
