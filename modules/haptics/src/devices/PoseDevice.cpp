#include "EventQueue.h"
#include "Rotation.h"

#include <insonate/haptics/PoseDevice.h>

#include <algorithm>
#include <utility>

namespace insonate {
namespace {

/// Limits of the time in which a difference is removed: one tick, and one interval of a camera of 15 fps.
constexpr std::int64_t kLeastBlend_ns = 1'000'000, kMostBlend_ns = 66'000'000;

bool isFinite(const DeviceState& state) noexcept {
  const auto& column = state.deviceFromStylus.linear.column;
  return insonate::isFinite(state.deviceFromStylus.offset) && insonate::isFinite(column[0]) &&
         insonate::isFinite(column[1]) && insonate::isFinite(column[2]) && insonate::isFinite(state.velocity_mmps) &&
         insonate::isFinite(state.angularVelocity_radps);
}

}  // namespace

PoseDevice::PoseDevice(std::string id, std::string name, double rate_Hz, Vec3 workspace_mm, DeviceKind kind)
    : info_{std::move(id), std::move(name), kind, {.sensedAxes = 6, .workspace_mm = workspace_mm, .rate_Hz = rate_Hz}} {
}

std::string PoseDevice::error() const {
  const std::lock_guard lock(mutex_);
  return sentence_;
}

DeviceQuality PoseDevice::quality() const {
  const std::lock_guard lock(mutex_);
  return quality_;
}

void PoseDevice::setQuality(DeviceQuality quality) {
  const std::lock_guard lock(mutex_);
  quality_ = std::move(quality);
}

void PoseDevice::setPhase(DevicePhase phase, std::string sentence) {
  if (phase != DevicePhase::kStreaming) ++gaps_;
  {
    const std::lock_guard lock(mutex_);
    sentence_ = std::move(sentence);
  }
  phase_.store(phase, std::memory_order_release);
}

void PoseDevice::post(const DeviceState& measured) noexcept {
  if (!isFinite(measured)) return;
  states_.post({measured, gaps_});
  posted_.fetch_add(1, std::memory_order_relaxed);
  if (phase() != DevicePhase::kStreaming) setPhase(DevicePhase::kStreaming);
}

void PoseDevice::take(const Measured& measured) noexcept {
  const bool isFirst = shown_.time_ns == 0 || measured.gaps != last_.gaps;
  const std::int64_t interval_ns = measured.state.time_ns - last_.state.time_ns;
  last_ = measured;
  // The transition begins with the last pose that was shown, so that it progresses however rarely poses are taken.
  begun_ns_ = shown_.time_ns;
  blend_ns_ = std::clamp(interval_ns, kLeastBlend_ns, kMostBlend_ns);
  off_mm_ = off_rad_ = {};
  if (isFirst) return;
  const DeviceState before = shown_;
  extrapolate(before.time_ns);
  off_mm_ = before.deviceFromStylus.offset - shown_.deviceFromStylus.offset;
  off_rad_ = haptics::turnOf(before.deviceFromStylus.linear * transposed(shown_.deviceFromStylus.linear));
}

/// Sets shown_ to the last state's pose at `now_ns`, plus the part of the difference that is not yet removed.
void PoseDevice::extrapolate(std::int64_t now_ns) noexcept {
  const DeviceState& from = last_.state;
  const std::int64_t ahead_ns = now_ns - from.time_ns;
  const double ahead_s = double(std::clamp<std::int64_t>(ahead_ns, 0, kMostAhead_ns)) * 1e-9;
  shown_ = from;
  shown_.time_ns = now_ns;
  Transform& pose = shown_.deviceFromStylus;
  pose.offset = from.deviceFromStylus.offset + from.velocity_mmps * ahead_s;
  pose.linear = haptics::turned(from.deviceFromStylus.linear, from.angularVelocity_radps * ahead_s);
  if (ahead_ns > kMostAhead_ns) shown_.velocity_mmps = shown_.angularVelocity_radps = {};
  const double part = std::clamp(double(now_ns - begun_ns_) / double(blend_ns_), 0., 1.);
  // The cubic 1 - 3 u^2 + 2 u^3 begins and ends without a step of the velocity.
  const double left = 1 - part * part * (3 - 2 * part);
  const double change_ps = -6 * part * (1 - part) / (double(blend_ns_) * 1e-9);
  pose = {haptics::turned(pose.linear, off_rad_ * left), pose.offset + off_mm_ * left};
  shown_.velocity_mmps = shown_.velocity_mmps + off_mm_ * change_ps;
  shown_.angularVelocity_radps = shown_.angularVelocity_radps + off_rad_ * change_ps;
}

bool PoseDevice::pollState(DeviceState& state) noexcept {
  return pollAt(haptics::monotonic_ns(), state);
}

bool PoseDevice::pollAt(std::int64_t now_ns, DeviceState& state) noexcept {
  if (const auto measured = states_.takeLatest()) take(*measured);
  if (phase() != DevicePhase::kStreaming || last_.state.time_ns == 0) return false;
  extrapolate(now_ns);
  state = shown_;
  return true;
}

}  // namespace insonate
