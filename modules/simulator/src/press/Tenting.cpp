#include <insonate/simulator/Tenting.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

constexpr double kMaxDepth_mm = 30, kMinRadius_mm = 1, kMaxRadius_mm = 30;
constexpr double kScalePerDepth = 1.2;  // limits strain, so that tissue does not fold
constexpr double kReach_scales = 6;
constexpr double kFinestStep_mm = 0.5, kSteps = 6;  // spacing of the separate lattice; points for each scale

/// Displacement by a needle around its tip, in the probe frame: from the tissue's rest position to where it is seen.
class Dent {
 public:
  Dent(const Tenting& tenting, const Transform& patientFromProbe) {
    const Transform probeFromPatient = inverted(patientFromProbe);
    tip_mm = probeFromPatient * tenting.tip_mm;
    direction_ = probeFromPatient.linear * tenting.direction;
    depth_mm_ = std::min(tenting.depth_mm, kMaxDepth_mm);
    scale_mm = std::max(std::clamp(tenting.radius_mm, kMinRadius_mm, kMaxRadius_mm), kScalePerDepth * depth_mm_);
    reach_mm = kReach_scales * scale_mm;
  }

  Vec3 at(Vec3 seen_mm) const {
    const Vec3 r = seen_mm - tip_mm;
    const double left = 1 - dot(r, r) / (reach_mm * reach_mm);
    if (left <= 0) return {};
    // At the tip one scale gives 1/e, so that the difference of the two gives 1/(2e).
    const Vec3 unit = (kelvinlet(r, scale_mm) - kelvinlet(r, 2 * scale_mm)) * (2 * scale_mm);
    return unit * (depth_mm_ * left * left);
  }

  Vec3 tip_mm;
  double scale_mm = 1, reach_mm = 1;

 private:
  /// Equation 6 with b = a/2, divided by a and the force.
  Vec3 kelvinlet(Vec3 r, double scale) const {
    const double re2 = dot(r, r) + scale * scale, re = std::sqrt(re2);
    return direction_ * (0.5 / re + 0.5 * scale * scale / (re2 * re)) + r * (0.5 * dot(r, direction_) / (re2 * re));
  }

  Vec3 direction_;
  double depth_mm_ = 0;
};

/// If no other tissue has moved, points around the tip suffice: the dent ends within them.
void layAround(const Dent& dent, PlaneDisplacement& field) {
  field.step_mm = std::max(kFinestStep_mm, dent.scale_mm / kSteps);
  const int half = static_cast<int>(std::ceil(dent.reach_mm / field.step_mm));
  field.columns = field.rows = 2 * half + 1;
  field.left_mm = dent.tip_mm.x - half * field.step_mm;
  field.top_mm = dent.tip_mm.z - half * field.step_mm;
}

}  // namespace

const PlaneDisplacement& TentedTissue::addTenting(const PlaneDisplacement& pressed, const Transform& patientFromProbe,
                                                  const Tenting& tenting) {
  const bool dents = tenting.depth_mm > 0 && std::isfinite(tenting.radius_mm) && isFinite(tenting.tip_mm) &&
                     isFinite(tenting.direction);
  if (!dents) return pressed;
  const Dent dent(tenting, patientFromProbe);
  if (std::abs(dent.tip_mm.y) >= dent.reach_mm) return pressed;
  dented_.left_mm = pressed.left_mm, dented_.top_mm = pressed.top_mm, dented_.step_mm = pressed.step_mm;
  dented_.columns = pressed.columns, dented_.rows = pressed.rows;
  dented_.lung = pressed.lung;
  if (pressed.empty()) layAround(dent, dented_);
  dented_.restFromDisplayed.resize(std::size_t(dented_.columns) * dented_.rows);
  auto shift = dented_.restFromDisplayed.begin();
  for (int row = 0; row < dented_.rows; ++row)
    for (int column = 0; column < dented_.columns; ++column, ++shift) {
      const Vec3 seen{dented_.left_mm + column * dented_.step_mm, 0, dented_.top_mm + row * dented_.step_mm};
      // Inverts the dent first: the needle pushes tissue that the probe has compressed.
      const Vec3 back = dent.at(seen);
      const Vec3 rest = shiftAt(pressed, seen.x - back.x, seen.z - back.z) - back;
      *shift = {static_cast<float>(rest.x), static_cast<float>(rest.z)};
    }
  return dented_;
}

}  // namespace insonate
