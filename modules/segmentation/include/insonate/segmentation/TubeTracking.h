#pragma once

#include <insonate/segmentation/VesselTracking.h>

namespace insonate {

/// Properties of the vessel to follow; the defaults are those of a neck's large vessels without contrast agent.
struct TubeTracking {
  double largest_mm = 12;  ///< maximum distance of the wall from the center; 2 to 30
  double darker_HU = 15;   ///< voxels darker than the center by at least this much belong to other tissue; 1 to 500
  double brighter_HU = 9;  ///< voxels brighter than the center by at least this much belong to other tissue; 1 to 500
  double stiffness = 2;    ///< resistance of an outline to dents and bumps; 0 to 10
};

/// Follows a structure that differs little from its surroundings along clicks in its center: a vessel without contrast
/// agent, visible by the fat around it, or a muscle, visible by its fasciae. The line between clicks is smooth.
/// Sections a millimeter apart are averaged along the line, but not blurred, since fasciae are no thicker than a voxel.
/// Each section takes the closed outline that best separates voxels similar to the clicks from others. The sections are
/// then centered, stretched according to their shape, so that flat structures are found, too, and fitted again. In a
/// noisy CT, both HU limits are widened. Refuses the same clicks as trackVessel(), except those without contrast; fails
/// when cancelled.
Result<TrackedVessel> trackTube(const CtVolume& ct, std::span<const Vec3> clicks_mm, const TubeTracking& how = {},
                                const Progress& progress = {});

}  // namespace insonate
