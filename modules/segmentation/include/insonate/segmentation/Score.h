#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace insonate {

/// Agreement of a label map with a reference map for one label.
struct LabelScore {
  std::uint8_t label = 0;
  std::size_t voxels = 0, trueVoxels = 0;
  double dice = 0;  ///< Dice coefficient 2 |A and B| / (|A| + |B|) of the voxel sets A and B of the two maps
  /// Mean and 95th percentile of surface distances: from each outermost voxel of either map to the nearest outermost
  /// voxel of the other. No value if either map has no voxel of the label.
  std::optional<double> meanSurface_mm, p95Surface_mm;
};

/// Compares the label map `found` with the reference map `truth` for these labels; if `labels` is empty, for all labels
/// except background that occur in either map. Fails if the grids differ, and when cancelled.
Result<std::vector<LabelScore>> scoreLabels(const LabelMap& found, const LabelMap& truth,
                                            const std::vector<std::uint8_t>& labels = {},
                                            const Progress& progress = {});

}  // namespace insonate
