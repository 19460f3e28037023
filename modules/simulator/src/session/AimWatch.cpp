#include "session/AimWatch.h"

#include "hands/RestNear.h"

#include <insonate/haptics/NeedleState.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

constexpr double kAimStep_mm = 0.5;
/// Shorter paths through a vein that is not the target are taken for the border of the target.
constexpr double kOtherVein_mm = 1.5;

int wallOf(Label label) {
  return static_cast<int>(std::ranges::find(kNeedleWalls, label) - kNeedleWalls.begin());
}

bool isInside(const VolumeGeometry& volume, Vec3 index) {
  return volume.contains(static_cast<int>(std::lround(index.x)), static_cast<int>(std::lround(index.y)),
                         static_cast<int>(std::lround(index.z)));
}

}  // namespace

NeedleAim aimOf(const LiveFrame& frame, double tent_mm, const TissueGrid& grid, const VesselLocator& vessels,
                std::span<const CenterLine> veins) noexcept {
  if (!frame.needle) return NeedleAim::Unknown;
  const int vein = wallOf(kVein);
  const Transform indexFromPatient = grid.geometry().indexFromPatient();
  const Transform probeFromPatient = inverted(frame.patientFromProbe);
  const Vec3 tip_mm = probeFromPatient * frame.needle->tip_mm;
  const Vec3 direction = probeFromPatient.linear * frame.needle->direction;
  const auto restAt = [&](double ahead_mm) {
    const Vec3 at_mm = tip_mm + direction * ahead_mm;
    return frame.patientFromProbe * (at_mm + shiftNear(frame.press.displacement, at_mm));
  };
  double otherVein_mm = 0;
  bool wasInTarget = false;
  Vec3 before_mm = restAt(-tent_mm - kAimStep_mm);
  for (double ahead_mm = -tent_mm; ahead_mm <= frame.needle->length_mm; ahead_mm += kAimStep_mm) {
    const Vec3 from_mm = before_mm, at_mm = restAt(ahead_mm);
    before_mm = at_mm;
    const Label label =
        isInside(grid.geometry(), indexFromPatient * at_mm) ? knownLabel(grid.at(at_mm).label) : kBackground;
    if (label == kArtery) return NeedleAim::Artery;
    const bool isInTarget = label == kVein && vessels.isTarget(at_mm, veins);
    if (isInTarget && !wasInTarget && dot(normalized(at_mm - from_mm), grid.outward(at_mm, vein)) <= -kRollCosine)
      return NeedleAim::Vein;
    wasInTarget = isInTarget;
    if (label == kVein && !isInTarget && (otherVein_mm += kAimStep_mm) > kOtherVein_mm) return NeedleAim::Beside;
  }
  return NeedleAim::Beside;
}

}  // namespace insonate
