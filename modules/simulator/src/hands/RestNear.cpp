#include "hands/RestNear.h"

#include <insonate/simulator/LiveImaging.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

constexpr double kHalf_mm = 1.5;
constexpr double kThin_mm = 1;
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

Vec3 shiftNear(const PlaneDisplacement& displacement, Vec3 probe_mm) {
  if (displacement.empty()) return {};
  const double share = std::clamp(2 - std::abs(probe_mm.y) / kMovesBeside_mm, 0.0, 1.0);
  if (share == 0) return {};
  return shiftAt(displacement, probe_mm.x, probe_mm.z) * (share * shareAside(displacement, probe_mm.x));
}

void thinOut(const PlaneDisplacement& displacement, PlaneDisplacement& thin) {
  const int every = std::max(1, static_cast<int>(std::ceil(kThin_mm / displacement.step_mm - 1e-6)));
  thin.left_mm = displacement.left_mm, thin.top_mm = displacement.top_mm;
  thin.step_mm = every * displacement.step_mm;
  thin.columns = (displacement.columns + every - 1) / every;
  thin.rows = (displacement.rows + every - 1) / every;
  thin.restFromDisplayed.resize(static_cast<std::size_t>(thin.columns) * thin.rows);
  for (int row = 0; row < thin.rows; ++row)
    for (int column = 0; column < thin.columns; ++column)
      thin.restFromDisplayed[static_cast<std::size_t>(row) * thin.columns + column] =
          displacement.restFromDisplayed[static_cast<std::size_t>(row) * every * displacement.columns + column * every];
}

Transform restNear(const PlaneDisplacement& displacement, const Transform& patientFromProbe, Vec3 patient_mm) {
  if (displacement.empty()) return {};
  const Transform probeFromPatient = inverted(patientFromProbe);
  const Vec3 at = probeFromPatient * patient_mm;
  if (std::abs(at.y) >= 2 * kMovesBeside_mm) return {};
  const auto shift = [&](double x, double z) { return shiftNear(displacement, {x, at.y, z}); };
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
