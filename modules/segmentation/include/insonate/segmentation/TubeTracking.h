#pragma once

#include <insonate/segmentation/VesselTracking.h>

namespace insonate {

/// Properties of the vessel to track; the defaults are for large vessels of the neck without contrast agent.
struct TubeTracking {
  double largest_mm = 12;  ///< maximum distance of the wall from the center; 2 to 30
  double darker_HU = 15;   ///< voxels darker than the center by at least this much belong to other tissue; 1 to 500
  double brighter_HU = 9;  ///< voxels brighter than the center by at least this much belong to other tissue; 1 to 500
  double stiffness = 2;    ///< resistance of an outline to dents and bumps; 0 to 10
};

/// Tracks a structure that differs little from its surroundings: a vessel without contrast agent, which the fat around
/// it makes visible, or a muscle, which its fasciae make visible. The author has clicked points along its center; a
/// smooth line connects them. Cross-sections are taken every millimeter. The CT is averaged along the line, but not
/// blurred within a section, since fasciae are no thicker than a voxel. In each section, the outline is the closed
/// curve that best separates voxels similar to those at the clicks from other voxels. The sections are then centered
/// and stretched according to their shape, so that flat structures are also found, and the outlines are fitted again.
/// In a noisy CT, both HU limits are widened. Refuses the same clicks as trackVessel(), except clicks on blood without
/// contrast; fails when cancelled.
Result<TrackedVessel> trackTube(const CtVolume& ct, std::span<const Vec3> clicks_mm, const TubeTracking& how = {},
                                const Progress& progress = {});

}  // namespace insonate
