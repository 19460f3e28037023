#include <insonate/haptics/HapticDevice.h>

namespace insonate {
namespace {

Vec3 shortened(Vec3 v, double most) noexcept {
  if (!isFinite(v)) return {};
  const double length = norm(v);
  return length > most ? v * (most / length) : v;
}

}  // namespace

std::string_view nameOf(DevicePhase phase) {
  switch (phase) {
    case DevicePhase::kAbsent:
      return "absent";
    case DevicePhase::kOpening:
      return "opening";
    case DevicePhase::kReady:
      return "ready";
    case DevicePhase::kStreaming:
      return "streaming";
    case DevicePhase::kLost:
      return "lost";
    case DevicePhase::kFailed:
      return "failed";
  }
  return "";
}

Force limitedForce(const DeviceLimits& limits, const Force& force) noexcept {
  Force held;
  if (limits.forceAxes >= 3) held.force_N = shortened(force.force_N, limits.maxForce_N);
  if (limits.forceAxes >= 6) held.torque_Nmm = shortened(force.torque_Nmm, limits.maxTorque_Nmm);
  return held;
}

}  // namespace insonate
