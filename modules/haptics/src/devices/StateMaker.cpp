#include "StateMaker.h"

#include "Rotation.h"

#include <algorithm>
#include <cmath>

namespace insonate::haptics {
namespace {

/// Continuous from rest to full deflection.
double pressed(double deflection) noexcept {
  const double beyond = std::max(0.0, std::abs(deflection) - StateMaker::kCapRest) / (1 - StateMaker::kCapRest);
  return std::copysign(beyond, deflection);
}

}  // namespace

StateMaker::StateMaker(const DeviceTable& table) : table_(table) {
  if (table.arm) arm_.emplace(*table.arm);
  for (const ReportLayout& report : table.input)
    for (const ReportField& field : report.fields) byCap_ |= field.quantity == Quantity::kDeflection;
}

void StateMaker::reset() noexcept {
  const Transform pose = state_.deviceFromStylus;
  state_ = {};
  home_ = {};
  // A pose that follows from the deflection of a cap stays when the cap is released; other devices report their pose.
  if (byCap_) state_.deviceFromStylus = pose;
}

std::array<double, 3> StateMaker::anglesOf(const DeviceReading& reading) const noexcept {
  return arm_->anglesOf({reading.encoder[0] - home_[0], reading.encoder[1] - home_[1], reading.encoder[2] - home_[2]});
}

void StateMaker::moveByCap(const DeviceReading& reading, std::int64_t reported_ns, std::int64_t now_ns) noexcept {
  const bool heard = now_ns - reported_ns < kCapSilence_ns;
  std::array<double, 6> press{};
  if (heard) std::transform(reading.deflection.begin(), reading.deflection.end(), press.begin(), pressed);
  state_.velocity_mmps = Vec3{press[0], press[1], press[2]} * kCapSpeed_mmps;
  state_.angularVelocity_radps = Vec3{press[3], press[4], press[5]} * kCapTurn_radps;
  const double step_s = state_.time_ns == 0 ? 0 : std::clamp((now_ns - state_.time_ns) * 1e-9, 0.0, 0.1);
  Transform& pose = state_.deviceFromStylus;
  const Vec3 half = table_.limits.workspace_mm / 2;
  for (int axis = 0; axis < 3; ++axis)
    pose.offset[axis] = std::clamp(pose.offset[axis] + state_.velocity_mmps[axis] * step_s, -half[axis], half[axis]);
  pose.linear = turned(pose.linear, state_.angularVelocity_radps * step_s);
}

DeviceState StateMaker::make(const DeviceReading& reading, std::int64_t reported_ns, std::int64_t now_ns) noexcept {
  if (byCap_) {
    moveByCap(reading, reported_ns, now_ns);
  } else if (arm_) {
    state_.deviceFromStylus.offset = arm_->position_mm(anglesOf(reading));
  } else if (reading.position_mm) {
    state_.deviceFromStylus = {rotationOf(reading.quaternion), *reading.position_mm};
  }
  state_.buttons = reading.buttons;
  state_.time_ns = now_ns;
  return state_;
}

DeviceOutput StateMaker::outputFor(const Force& force, const DeviceReading& reading) const noexcept {
  DeviceOutput output{force.force_N, force.torque_Nmm, {}, 0};
  if (arm_) output.current_mA = arm_->currents_mA(anglesOf(reading), force.force_N);
  return output;
}

}  // namespace insonate::haptics
