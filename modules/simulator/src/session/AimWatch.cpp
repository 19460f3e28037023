#include "session/AimWatch.h"

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

}  // namespace

NeedleAim aimOf(const Needle& needle, const TissueGrid& grid, const VesselLocator& vessels,
                std::span<const CenterLine> veins) noexcept {
  const int vein = wallOf(kVein), skin = wallOf(kSkin);
  const VolumeGeometry& volume = grid.geometry();
  const Transform indexFromPatient = volume.indexFromPatient();
  const bool isIn = grid.at(needle.tip_mm).distance_mm[skin] < 0;
  bool isNear = false;
  double otherVein_mm = 0;
  for (double ahead_mm = 0; ahead_mm <= needle.length_mm; ahead_mm += kAimStep_mm) {
    const Vec3 at_mm = needle.tip_mm + needle.direction * ahead_mm;
    const Vec3 index = indexFromPatient * at_mm;
    if (!volume.contains(static_cast<int>(std::lround(index.x)), static_cast<int>(std::lround(index.y)),
                         static_cast<int>(std::lround(index.z))))
      continue;
    const TissueSample sample = grid.at(at_mm);
    if (sample.label == kArtery) return isNear ? NeedleAim::Vein : NeedleAim::Artery;
    if (sample.label == kVein) {
      if (vessels.isTarget(at_mm, veins)) return NeedleAim::Vein;
      if ((otherVein_mm += kAimStep_mm) > kOtherVein_mm) return NeedleAim::Beside;
    }
    isNear |= isIn && std::abs(sample.distance_mm[vein]) <= kAimTolerance_mm;
  }
  return isNear ? NeedleAim::Vein : NeedleAim::Beside;
}

}  // namespace insonate
