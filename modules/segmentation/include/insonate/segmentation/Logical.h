#pragma once

#include <insonate/segmentation/Region.h>

namespace insonate {

enum class LogicalOperation { kAdd, kSubtract, kIntersect };

/// Combines two selections. The result has the box of `a`; for kAdd, the box around both.
Selection combined(const Selection& a, LogicalOperation operation, const Selection& b, const VolumeGeometry& geometry);

/// Returns the voxels of the selection's box that are not selected.
Selection inverted(Selection selection);

}  // namespace insonate
