#pragma once

#include <insonate/segmentation/VesselTracking.h>

namespace insonate {

/// Properties of the vessel to follow; the defaults are those of a neck's large vessels without contrast agent.
struct TubeTracking {
  double largest_mm = 12;  ///< no wall is looked for farther from the middle; 2 to 30
  double darker_HU = 15;   ///< what is so much darker than the middle is something else; 1 to 500
  double brighter_HU = 9;  ///< what is so much brighter; 1 to 500
  double stiffness = 2;    ///< how much an outline resists dents and bumps; 0 to 10
};

/// Follows a structure that differs little from its surroundings along clicks in its middle: a vessel without contrast
/// agent, visible by the fat around it, or a muscle by its fasciae. Between clicks the line is smooth. Sections a
/// millimeter apart are averaged along the line instead of blurred, since fasciae are no thicker than a voxel, and
/// take the closed outline that best separates voxels like the clicks from others; then they are centered and
/// stretched by their shape, so that flat tubes are found, too, and fitted again. In a noisy CT both limits are wider.
/// Refuses what trackVessel() refuses except a lack of contrast; fails when cancelled.
Result<TrackedVessel> trackTube(const CtVolume& ct, std::span<const Vec3> clicks_mm, const TubeTracking& how = {},
                                const Progress& progress = {});

}  // namespace insonate
