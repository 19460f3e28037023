#include "servo/RealTime.h"

#include <insonate/haptics/SimulatedDevice.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

/// Duration of a pause after which the hand does not catch up.
constexpr double kLongest_s = 0.02;

}  // namespace

SimulatedDevice::SimulatedDevice(std::string id, const DeviceProfile& profile, const Grip& grip,
                                 const HandPath::Point& start)
    : hand_(profile.limits, grip, start.position_mm) {
  info_.id = std::move(id);
  info_.name = std::string(profile.name) + " (simulated)";
  info_.limits = profile.limits;
  setTarget(start);
}

void SimulatedDevice::setTarget(const HandPath::Point& point) {
  follow({{point}});
}

void SimulatedDevice::follow(HandPath path) {
  intent_.write({std::move(path), haptics::monotonic_ns()});
}

std::string SimulatedDevice::error() const {
  return phase_ == DevicePhase::kLost ? info_.name + " was unplugged." : std::string{};
}

bool SimulatedDevice::pollState(DeviceState& state) noexcept {
  const std::int64_t now_ns = haptics::monotonic_ns();
  const Intent& intent = intent_.read();
  const double length_s = intent.path.points.empty() ? 0 : intent.path.points.back().time_s;
  double time_s = static_cast<double>(now_ns - intent.begin_ns) * 1e-9;
  if (length_s > 0) time_s = std::fmod(time_s, length_s);
  const double step_s = time_ns_ > 0 ? std::min(static_cast<double>(now_ns - time_ns_) * 1e-9, kLongest_s) : 0;
  time_ns_ = now_ns;
  if (phase_ == DevicePhase::kLost) force_ = {};
  if (step_s > 0) hand_.move(intent.path.at(time_s), force_, step_s);
  observer_.add(hand_.intoLoop_J() + hand_.lost_J(), norm(force_.force_N) > 0);
  minEnergy_J_ = observer_.minEnergy_J();
  if (phase_ == DevicePhase::kLost) return false;
  state = hand_.state(now_ns);
  ++taken_;
  return true;
}

void SimulatedDevice::push(const Force& force) noexcept {
  force_ = limitedForce(info_.limits, force);
  ++pushed_;
}

}  // namespace insonate
