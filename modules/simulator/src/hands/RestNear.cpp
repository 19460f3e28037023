#include "hands/RestNear.h"

#include <insonate/simulator/LiveImaging.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

constexpr double kHalf_mm = 1.5;
/// Limits of the map's determinant: tissue keeps its volume except for the part that leaves the plane.
constexpr double kMinStretch = 0.2, kMaxStretch = 5;

/// 1 within the lattice, whose outermost shifts continue beside it and fall to 0.
double shareAside(const PlaneDisplacement& displacement, double x_mm) {
  constexpr double kFade_mm = 8;
  const double right_mm = displacement.left_mm + (displacement.columns - 1) * displacement.step_mm;
  const double beside_mm = std::max(displacement.left_mm - x_mm, x_mm - right_mm);
  return std::clamp(1 - beside_mm / kFade_mm, 0.0, 1.0);
}

}  // namespace

Transform restNear(const PlaneDisplacement& displacement, const Transform& patientFromProbe, Vec3 patient_mm) {
  if (displacement.empty()) return {};
  const Transform probeFromPatient = inverted(patientFromProbe);
  const Vec3 at = probeFromPatient * patient_mm;
  const double share = std::clamp(2 - std::abs(at.y) / kMovesBeside_mm, 0.0, 1.0);
  if (share == 0) return {};
  const auto shift = [&](double x, double z) {
    return shiftAt(displacement, x, z) * (share * shareAside(displacement, x));
  };
  const Vec3 acrossX = (shift(at.x + kHalf_mm, at.z) - shift(at.x - kHalf_mm, at.z)) / (2 * kHalf_mm);
  const Vec3 acrossZ = (shift(at.x, at.z + kHalf_mm) - shift(at.x, at.z - kHalf_mm)) / (2 * kHalf_mm);
  Transform restFromDisplayed{{{Vec3{1, 0, 0} + acrossX, Vec3{0, 1, 0}, Vec3{0, 0, 1} + acrossZ}}, {}};
  const double segment = determinant(restFromDisplayed.linear);
  if (!(segment > kMinStretch && segment < kMaxStretch)) restFromDisplayed.linear = {};
  restFromDisplayed.offset = at + shift(at.x, at.z) - restFromDisplayed.linear * at;
  return patientFromProbe * restFromDisplayed * probeFromPatient;
}

void restAlongMiddle(const PlaneDisplacement& displacement, const Transform& patientFromProbe, double depth_mm,
                     std::vector<Vec3>& points_mm) {
  points_mm.resize(static_cast<std::size_t>(std::max(0.0, depth_mm / kMiddleStep_mm)));
  for (std::size_t i = 0; i < points_mm.size(); ++i) {
    const double z_mm = (static_cast<double>(i) + 0.5) * kMiddleStep_mm;
    points_mm[i] = patientFromProbe * (Vec3{0, 0, z_mm} + shiftAt(displacement, 0, z_mm));
  }
}

}  // namespace insonate
