#pragma once

#include <insonate/segmentation/Region.h>

namespace insonate {

enum class LogicalOperation { kAdd, kSubtract, kIntersect };

/// Combines two selections; the result has the box of the first, or of both for a union.
Selection combined(const Selection& a, LogicalOperation operation, const Selection& b, const VolumeGeometry& geometry);

/// Voxels of the box that are not selected.
Selection inverted(Selection selection);

}  // namespace insonate
