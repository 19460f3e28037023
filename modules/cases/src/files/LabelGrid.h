#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <span>
#include <string>
#include <vector>

namespace insonate {

/// In voxels. Places exactly between two voxels, as grids of twice the spacing have them, are moved by so much, or
/// rounding would choose now one and now the other.
inline constexpr double kOffTheBorder = 1e-4;

/// True where a voxel of another grid at this place, and its neighbors one step away, are centred on voxels of `grid`
/// or of its continuation beyond the border.
bool fallsOnVoxels(const VolumeGeometry& grid, Vec3 place_mm, std::span<const Vec3> steps_mm);

/// True where every voxel of `part` is one of `grid`'s, and their axes point alike.
bool isPartOf(const VolumeGeometry& part, const VolumeGeometry& grid);

/// Adds the note about labels that came from another grid.
void noteOtherGrid(bool onVoxels, std::size_t lost, std::vector<std::string>& notes);

/// Labels of one grid on another: each voxel takes the nearest one's label, which is exact where voxels fall on voxels.
/// Says what was done. Fails where no labeled voxel lies in `grid`, and when cancelled.
Result<LabelMap> placeLabels(const LabelMap& labels, const VolumeGeometry& grid, std::vector<std::string>& notes,
                             const Progress& progress = {});

}  // namespace insonate
