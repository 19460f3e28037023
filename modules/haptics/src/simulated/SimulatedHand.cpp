#include <insonate/haptics/SimulatedHand.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

constexpr double kStep_s = 50e-6;

double rounded(double value, double step) {
  return step > 0 ? std::round(value / step) * step : value;
}

}  // namespace

SimulatedHand::SimulatedHand(const DeviceLimits& device, const Grip& grip, Vec3 start_mm)
    : device_(device), grip_(grip), position_mm_(start_mm) {}

void SimulatedHand::move(const HandPath::Point& want, const Force& force, double tick_s) {
  Vec3 pushed_N = force.force_N;
  if (const double n = norm(pushed_N); n > device_.maxForce_N && n > 0) pushed_N = pushed_N * (device_.maxForce_N / n);
  const int steps = std::max(1, static_cast<int>(std::lround(tick_s / kStep_s)));
  const double dt = tick_s / steps, mass_kg = device_.mass_kg + grip_.mass_kg;
  attitude_ = want.attitude;
  for (int i = 0; i < steps; ++i) {
    // m/s2 are N/kg, and a mm is a thousandth of a m.
    const Vec3 grip_N =
        (want.position_mm - position_mm_) * grip_.stiffness_Npmm - velocity_mmps_ * (grip_.damping_Nspm * 1e-3);
    const Vec3 drag_N = velocity_mmps_ * (-device_.damping_Nspm * 1e-3);
    velocity_mmps_ = velocity_mmps_ + (pushed_N + grip_N + drag_N) * (1e3 * dt / mass_kg);
    // Dry friction reduces the speed, at most to zero.
    const double speed = norm(velocity_mmps_), less = std::min(speed, 1e3 * dt * device_.friction_N / mass_kg);
    if (speed > 0) velocity_mmps_ = velocity_mmps_ * (1 - less / speed);
    const Vec3 moved_mm = velocity_mmps_ * dt;
    position_mm_ = position_mm_ + moved_mm;
    intoLoop_mJ_ -= dot(pushed_N, moved_mm);
    lost_mJ_ += less * mass_kg / (1e3 * dt) * norm(moved_mm) - dot(drag_N, moved_mm);
  }
}

DeviceState SimulatedHand::state(std::int64_t time_ns) const {
  DeviceState state;
  const double step = device_.resolution_mm;
  state.deviceFromStylus = {
      attitude_, {rounded(position_mm_.x, step), rounded(position_mm_.y, step), rounded(position_mm_.z, step)}};
  state.time_ns = time_ns;
  return state;
}

void PassivityObserver::add(double into_J, bool felt) {
  if (!felt) begin_J_ = into_J;
  minEnergy_J_ = std::min(minEnergy_J_, into_J - begin_J_);
}

}  // namespace insonate
