#include "VesselPath.h"

#include "tools/SeedFront.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace insonate::segmentation {
namespace {

constexpr double kAside_mm = 25;  // maximum distance of a vessel from the line between two clicks
constexpr double kStepsPerMm = 16, kUnlikeBlood = 8;

}  // namespace

std::vector<Vec3> pathThroughBlood(const CtVolume& ct, Vec3 from_mm, Vec3 to_mm, const BloodLevel& level, Work& work) {
  const VoxelBox box = boxAround(ct.geometry, std::array{from_mm, to_mm}, kAside_mm);
  const VolumeGeometry part = gridOf(ct.geometry, box);
  const Transform indexFromPatient = part.indexFromPatient(), patientFromIndex = part.patientFromIndex();
  const auto [fi, fj, fk] = nearestVoxel(indexFromPatient * from_mm);
  const auto [ti, tj, tk] = nearestVoxel(indexFromPatient * to_mm);

  Proposal front{box, Volume<std::uint8_t>(part, Proposal::kKeep)};
  front.labels.at(fi, fj, fk) = 1;
  Selection everywhere(ct.geometry, box);
  std::ranges::fill(everywhere.mask.voxels, std::uint8_t{1});
  const CtVolume hu = cropped(ct, box);
  SeedFront run(front, everywhere);
  run.run(work, [&](std::uint32_t cost, std::uint32_t, std::uint32_t to, int axis) {
    const double perMm = 1 + kUnlikeBlood * level.unlikeness(hu.voxels[to]);
    const auto step = static_cast<std::uint32_t>(kStepsPerMm * perMm * part.spacing_mm[axis]);
    return cost + std::clamp(step, 1U, SeedFront::kBuckets - 1);
  });

  // Follows the path back to its start, each step to the neighbor with the lowest cost.
  std::vector<Vec3> path;
  std::array at{ti, tj, tk};
  while (true) {
    path.push_back(patientFromIndex * Vec3{double(at[0]), double(at[1]), double(at[2])});
    const std::array here = at;
    std::uint32_t least = run.cost(part.offset(here[0], here[1], here[2]));
    if (least == 0) break;
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) {
        std::array next = here;
        next[axis] += step;
        if (!part.contains(next[0], next[1], next[2])) continue;
        const std::uint32_t cost = run.cost(part.offset(next[0], next[1], next[2]));
        if (cost < least) least = cost, at = next;
      }
  }
  std::ranges::reverse(path);
  return path;
}

}  // namespace insonate::segmentation
