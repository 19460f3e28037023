#pragma once

#include <insonate/segmentation/VesselTracking.h>

namespace insonate::segmentation {

/// The voxels whose centers lie in the outlines, between the first and the last.
Selection fillLumen(const VolumeGeometry& geometry, std::span<const VesselOutline> outlines);

}  // namespace insonate::segmentation
