#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <span>
#include <string>
#include <vector>

namespace insonate {

/// Shift of all positions, in voxels, before rounding to a voxel. Without the shift, positions exactly between two
/// voxels, as in grids of twice the spacing, would be rounded sometimes to one voxel and sometimes to the other.
inline constexpr double kOffTheBorder = 1e-4;

/// Tells whether a voxel of another grid at this position, and its neighbors one step away, are centered on voxels of
/// `grid` or of its continuation beyond the border.
bool fallsOnVoxels(const VolumeGeometry& grid, Vec3 place_mm, std::span<const Vec3> steps_mm);

/// Tells whether every voxel of `part` is a voxel of `grid`, with axes in the same directions.
bool isPartOf(const VolumeGeometry& part, const VolumeGeometry& grid);

/// Adds a note that labels came from another grid, with the number of labeled voxels that were lost, if any.
void noteOtherGrid(bool onVoxels, std::size_t lost, std::vector<std::string>& notes);

/// Places labels on another grid: each voxel takes the label of the nearest voxel, which is exact if the voxels of both
/// grids coincide. Adds a note. Fails if no labeled voxel lies in `grid`, and when cancelled.
Result<LabelMap> placeLabels(const LabelMap& labels, const VolumeGeometry& grid, std::vector<std::string>& notes,
                             const Progress& progress = {});

}  // namespace insonate
