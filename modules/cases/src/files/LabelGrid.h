#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <span>
#include <string>
#include <vector>

namespace insonate {

/// Shift in voxels. Places exactly between two voxels, as in grids of twice the spacing, are shifted by this, or
/// rounding would choose sometimes one and sometimes the other.
inline constexpr double kOffTheBorder = 1e-4;

/// Tells whether a voxel of another grid at this place, and its neighbors one step away, are centered on voxels of
/// `grid` or of its continuation beyond the border.
bool fallsOnVoxels(const VolumeGeometry& grid, Vec3 place_mm, std::span<const Vec3> steps_mm);

/// Tells whether every voxel of `part` is one of `grid`'s, with axes in the same directions.
bool isPartOf(const VolumeGeometry& part, const VolumeGeometry& grid);

/// Adds the note about labels that came from another grid.
void noteOtherGrid(bool onVoxels, std::size_t lost, std::vector<std::string>& notes);

/// Puts labels of one grid on another: each voxel takes the nearest one's label, which is exact where voxels fall on
/// voxels. Adds a note. Fails if no labeled voxel lies in `grid`, and when cancelled.
Result<LabelMap> placeLabels(const LabelMap& labels, const VolumeGeometry& grid, std::vector<std::string>& notes,
                             const Progress& progress = {});

}  // namespace insonate
