#include "NeckRegion.h"

#include "NeckPoses.h"

namespace insonate::phantom {
namespace {

VolumeGeometry neckGrid(bool chest) {
  VolumeGeometry g;
  g.size = {304, 284, 148};
  g.spacing_mm = {0.5, 0.5, 0.75};
  g.origin_mm = chest ? Vec3{-124.75, -36, -97.5} : Vec3{-75.75, -36, -61.5};
  return g;
}

}  // namespace

Region makeRegion(const NeckParameters& parameters, std::uint32_t seed) {
  const NeckModel neck(parameters, seed);
  Region region{static_cast<const RegionModel&>(neck), neckGrid(parameters.chest)};
  region.targets = parameters.chest ? chestTargets(neck, parameters.axillary) : jugularTargets(neck);
  region.startPoses = parameters.chest ? chestStartPoses(neck, parameters.axillary) : jugularStartPoses(neck);
  region.landmarks = landmarks(neck, region.startPoses);
  return region;
}

}  // namespace insonate::phantom
