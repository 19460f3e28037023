#include "servo/ForceGuard.h"

#include <algorithm>

namespace insonate::haptics {
namespace {

Vec3 shortened(Vec3 v, double most) {
  if (!isFinite(v)) return {};
  const double length = norm(v);
  return length > most ? v * (most / length) : v;
}

}  // namespace

Force ForceGuard::pass(const Force& wanted, std::int64_t silent_ns, std::int64_t step_ns) noexcept {
  const double silent_ms = static_cast<double>(silent_ns) * 1e-6;
  const double step_ms = std::clamp(static_cast<double>(step_ns) * 1e-6, 0.0, 10.0);
  // Limits the whole force, so that it decreases to zero in time whatever the slew limit is.
  const double share = std::clamp(1 - (silent_ms - limits_.silence_ms) / std::max(limits_.fall_ms, 1e-3), 0.0, 1.0);
  const Vec3 target = shortened(wanted.force_N, limits_.force_N);
  const Vec3 change = shortened(target - last_.force_N, limits_.slew_Npms * step_ms);
  last_.force_N = shortened(last_.force_N + change, share * limits_.force_N);
  last_.torque_Nmm = shortened(wanted.torque_Nmm, share * limits_.torque_Nmm);
  return last_;
}

}  // namespace insonate::haptics
