#include "servo/ToolContact.h"

#include <algorithm>

namespace insonate::haptics {

/// Ericson, Real-Time Collision Detection, 2005, section 5.1.9: the equations for two segments.
NearestPoints nearestPoints(const Capsule& a, const Capsule& b) {
  const Vec3 u = a.to - a.from, v = b.to - b.from, w = a.from - b.from;
  const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), uw = dot(u, w), vw = dot(v, w);
  const double area = uu * vv - uv * uv;
  double s = area > 1e-9 * uu * vv ? std::clamp((uv * vw - uw * vv) / area, 0.0, 1.0) : 0.0;
  double t = vv > 0 ? (uv * s + vw) / vv : 0;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = uu > 0 ? std::clamp((uv * t - uw) / uu, 0.0, 1.0) : 0;
  }
  return {a.from + u * s, b.from + v * t};
}

bool ToolContact::push(const Transform& patientFromProbe, const Transform& patientFromNeedle, const ToolShapes& shapes,
                       double stiffness_Npmm, Force& onProbe, Force& onNeedle) noexcept {
  const double r = shapes.probeRadius_mm, half = std::max(0.0, shapes.faceHalfWidth_mm - r);
  const std::array<Capsule, 2> probe{
      Capsule{patientFromProbe * Vec3{-half, 0, -r}, patientFromProbe * Vec3{half, 0, -r}, r},
      Capsule{patientFromProbe * Vec3{0, 0, -r}, patientFromProbe * Vec3{0, 0, -shapes.handle_mm}, r}};
  const Capsule needle{patientFromNeedle.offset, patientFromNeedle * Vec3{0, 0, -shapes.needleLength_mm},
                       shapes.needleRadius_mm};
  bool touches = false;
  for (int i = 0; i < 2; ++i) {
    Pair& pair = pairs_[i];
    const NearestPoints nearest = nearestPoints(probe[i], needle);
    const Vec3 apart = nearest.onB - nearest.onA;
    const double distance_mm = norm(apart), reach_mm = probe[i].radius_mm + needle.radius_mm;
    Vec3 direction = distance_mm > 1e-6 ? apart / distance_mm : pair.towardsNeedle;
    const bool through = pair.touches && dot(direction, pair.towardsNeedle) < 0;
    if (through) direction = -direction;
    const double depth_mm = through ? reach_mm + distance_mm : reach_mm - distance_mm;
    pair.touches = depth_mm > 0 && norm(direction) > 0 && (through || distance_mm < reach_mm);
    if (!pair.touches) continue;
    pair.towardsNeedle = direction;
    const Vec3 force_N = direction * (stiffness_Npmm * depth_mm);
    onNeedle.force_N = onNeedle.force_N + force_N;
    onNeedle.torque_Nmm = onNeedle.torque_Nmm + cross(nearest.onB - patientFromNeedle.offset, force_N);
    onProbe.force_N = onProbe.force_N - force_N;
    onProbe.torque_Nmm = onProbe.torque_Nmm - cross(nearest.onA - patientFromProbe.offset, force_N);
    touches = true;
  }
  return touches;
}

}  // namespace insonate::haptics
