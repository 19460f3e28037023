#pragma once

#include <insonate/segmentation/Region.h>

namespace insonate {

enum class LogicalOperation { kAdd, kSubtract, kIntersect };

/// In the box of both; the result has the box of the first, or of both where something is added.
Selection combined(const Selection& a, LogicalOperation operation, const Selection& b, const VolumeGeometry& geometry);

/// Voxels of the box that are not selected.
Selection inverted(Selection selection);

}  // namespace insonate
