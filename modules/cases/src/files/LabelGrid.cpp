#include "LabelGrid.h"

#include <insonate/image/VoxelBox.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace insonate {
namespace {

constexpr double kTenthOfAVoxel = 0.1;

double distanceToWhole(Vec3 index) {
  double worst = 0;
  for (int a = 0; a < 3; ++a) worst = std::max(worst, std::abs(index[a] - std::round(index[a])));
  return worst;
}

/// Number of labeled voxels whose center is outside the grid.
std::size_t lostVoxels(const LabelMap& labels, const VolumeGeometry& grid) {
  const Transform gridFromLabels = grid.indexFromPatient() * labels.geometry.patientFromIndex();
  const auto& size = labels.geometry.size;
  std::size_t lost = 0;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        if (labels.at(i, j, k) == 0) continue;
        const auto [x, y, z] = nearestVoxel(gridFromLabels * Vec3{double(i), double(j), double(k)});
        lost += !grid.contains(x, y, z);
      }
  return lost;
}

/// Steps from a voxel to its neighbors along i, j and k.
std::array<Vec3, 3> stepsOf(const VolumeGeometry& g) {
  const auto& axis = g.direction.column;
  return {axis[0] * g.spacing_mm.x, axis[1] * g.spacing_mm.y, axis[2] * g.spacing_mm.z};
}

}  // namespace

bool fallsOnVoxels(const VolumeGeometry& grid, Vec3 place_mm, std::span<const Vec3> steps_mm) {
  const Transform indexFromPatient = grid.indexFromPatient();
  if (distanceToWhole(indexFromPatient * place_mm) > kTenthOfAVoxel) return false;
  constexpr double kSameStep = 1e-3;
  return std::ranges::all_of(steps_mm, [&](Vec3 step_mm) {
    const Vec3 step = indexFromPatient.linear * step_mm;
    return distanceToWhole(step) < kSameStep && std::abs(norm(step) - 1) < kSameStep;
  });
}

bool isPartOf(const VolumeGeometry& part, const VolumeGeometry& grid) {
  const Vec3 last = part.patientFromIndex() * Vec3{part.size[0] - 1.0, part.size[1] - 1.0, part.size[2] - 1.0};
  const auto holds = [&](Vec3 place_mm) {
    const auto [i, j, k] = nearestVoxel(grid.indexFromPatient() * place_mm);
    return grid.contains(i, j, k);
  };
  constexpr double kSameAxis = 1e-4;
  for (int a = 0; a < 3; ++a)
    if (norm(part.direction.column[a] - grid.direction.column[a]) > kSameAxis) return false;
  return holds(part.origin_mm) && holds(last) && fallsOnVoxels(grid, part.origin_mm, stepsOf(part)) &&
         fallsOnVoxels(grid, last, {});
}

void noteOtherGrid(bool onVoxels, std::size_t lost, std::vector<std::string>& notes) {
  notes.push_back(onVoxels ? "The labels cover another part of the CT's grid; every voxel kept its place."
                           : "The labels lie on another grid; each voxel of the CT took the nearest label, so that "
                             "borders may have moved by half a voxel.");
  if (lost > 0) notes.push_back(std::to_string(lost) + " labeled voxels lie outside the CT and were left out.");
}

Result<LabelMap> placeLabels(const LabelMap& labels, const VolumeGeometry& grid, std::vector<std::string>& notes,
                             const Progress& progress) {
  LabelMap placed(grid);
  if (sameGrid(labels.geometry, grid)) {
    placed.voxels = labels.voxels;
    return placed;
  }
  Transform labelsFromGrid = labels.geometry.indexFromPatient() * grid.patientFromIndex();
  labelsFromGrid.offset = labelsFromGrid.offset - Vec3{kOffTheBorder, kOffTheBorder, kOffTheBorder};
  for (int k = 0; k < grid.size[2]; ++k) {
    if (!report(progress, "Placing labels", double(k) / grid.size[2])) return fail(std::string(kCancelled));
    tbb::parallel_for(0, grid.size[1], [&](int j) {
      for (int i = 0; i < grid.size[0]; ++i)
        placed.at(i, j, k) = sampleNearest(labels, labelsFromGrid * Vec3{double(i), double(j), double(k)});
    });
  }
  const auto labeled = [](const LabelMap& map) {
    return std::ranges::any_of(map.voxels, [](std::uint8_t v) { return v != 0; });
  };
  if (!labeled(placed) && labeled(labels))
    return fail("the labels lie outside the CT: they were drawn on another CT. Choose the labels of this CT.");
  noteOtherGrid(fallsOnVoxels(grid, labels.geometry.origin_mm, stepsOf(labels.geometry)), lostVoxels(labels, grid),
                notes);
  return placed;
}

}  // namespace insonate
