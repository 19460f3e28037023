#include "EventQueue.h"
#include "Rotation.h"

#include <insonate/haptics/MouseDevice.h>

#include <algorithm>
#include <cmath>

namespace insonate {

MouseDevice::MouseDevice(std::string id, std::string name)
    : info_{std::move(id),
            std::move(name),
            DeviceKind::kMotion,
            {.sensedAxes = 6,
             .workspace_mm = {kWorkspace_mm, kWorkspace_mm, kWorkspace_mm},
             .rate_Hz = 1000,
             .resolution_mm = 0.01}} {}

void MouseDevice::setConnected(bool held) noexcept {
  if (held == (phase() != DevicePhase::kAbsent)) return;
  phase_.store(held ? DevicePhase::kReady : DevicePhase::kAbsent, std::memory_order_release);
  // Keys and buttons that were down when the tool was put down are not down when it is picked up.
  wish_.glide_mmps = wish_.glide_radps = {};
  wish_.buttons = 0;
  wishes_.post(wish_);
}

void MouseDevice::moveBy(Vec3 by_mm) noexcept {
  if (!isFinite(by_mm)) return;
  wish_.dragged_mm = wish_.dragged_mm + by_mm;
  wishes_.post(wish_);
}

void MouseDevice::turnBy(Vec3 by_rad) noexcept {
  if (!isFinite(by_rad)) return;
  wish_.turned = haptics::turned(wish_.turned, by_rad);
  wishes_.post(wish_);
}

void MouseDevice::setVelocity(Vec3 velocity_mmps, Vec3 turning_radps) noexcept {
  if (!isFinite(velocity_mmps) || !isFinite(turning_radps)) return;
  wish_.glide_mmps = velocity_mmps;
  wish_.glide_radps = turning_radps;
  wishes_.post(wish_);
}

void MouseDevice::placeAt(const Transform& deviceFromStylus) noexcept {
  wish_.place = deviceFromStylus;
  wish_.dragged_mm = {};  // later drags count from here
  wish_.turned = {};
  ++wish_.places;
  wishes_.post(wish_);
}

void MouseDevice::setButton(int button, bool down) noexcept {
  if (button < 0 || button > 31) return;
  const std::uint32_t bit = 1U << button;
  wish_.buttons = down ? wish_.buttons | bit : wish_.buttons & ~bit;
  wishes_.post(wish_);
}

void MouseDevice::obey(const Wish& wish) noexcept {
  if (wish.places != seen_.places) {
    state_.deviceFromStylus = wish.place;
    target_ = {wish.turned * wish.place.linear, wish.place.offset + wish.dragged_mm};
  } else {
    target_.offset = target_.offset + wish.dragged_mm - seen_.dragged_mm;
    target_.linear = wish.turned * transposed(seen_.turned) * target_.linear;
  }
  seen_ = wish;
}

void MouseDevice::follow(double step_s) noexcept {
  target_.offset = target_.offset + seen_.glide_mmps * step_s;
  target_.linear = haptics::turned(target_.linear, seen_.glide_radps * step_s);
  const Vec3 middle_mm = seen_.place.offset;
  for (int axis = 0; axis < 3; ++axis)
    target_.offset[axis] =
        std::clamp(target_.offset[axis], middle_mm[axis] - kWorkspace_mm / 2, middle_mm[axis] + kWorkspace_mm / 2);
  const double part = 1 - std::exp(-step_s / kFollow_s);
  Transform& pose = state_.deviceFromStylus;
  const Vec3 step_mm = (target_.offset - pose.offset) * part;
  const Vec3 step_rad = haptics::turnOf(target_.linear * transposed(pose.linear)) * part;
  pose = {haptics::turned(pose.linear, step_rad), pose.offset + step_mm};
  state_.velocity_mmps = step_mm / step_s;
  state_.angularVelocity_radps = step_rad / step_s;
}

bool MouseDevice::pollState(DeviceState& state) noexcept {
  return pollAt(haptics::monotonic_ns(), state);
}

bool MouseDevice::pollAt(std::int64_t now_ns, DeviceState& state) noexcept {
  if (const auto wish = wishes_.takeLatest()) obey(*wish);
  if (phase() == DevicePhase::kAbsent) return false;
  // Excludes the time for which the tool was put down.
  const double step_s = state_.time_ns == 0 ? 0 : std::min(static_cast<double>(now_ns - state_.time_ns) * 1e-9, 0.05);
  if (step_s > 0) follow(step_s);
  state_.time_ns = now_ns;
  state_.buttons = seen_.buttons;
  state = state_;
  taken_.fetch_add(1, std::memory_order_relaxed);
  DevicePhase ready = DevicePhase::kReady;
  phase_.compare_exchange_strong(ready, DevicePhase::kStreaming, std::memory_order_acq_rel);
  return true;
}

}  // namespace insonate
