#pragma once

#include <insonate/segmentation/VesselTracking.h>

namespace insonate::segmentation {

/// Returns the voxels whose centers lie within the outlines, between the first and the last outline.
Selection fillLumen(const VolumeGeometry& geometry, std::span<const VesselOutline> outlines);

}  // namespace insonate::segmentation
