#pragma once

#include <insonate/segmentation/VesselTracking.h>

#include <vector>

namespace insonate::segmentation {

/// Means over this many neighbors on both sides, as many on one side as on the other, so that the ends stay.
std::vector<Vec3> smoothed(const std::vector<Vec3>& line, int reach);

/// Points a millimeter apart on a polyline.
std::vector<Vec3> resampled(const std::vector<Vec3>& line);

/// Sections perpendicular to a line, turned as little as possible from one to the next, so that a ray stays on its
/// side.
std::vector<VesselOutline> sectionsAlong(const std::vector<Vec3>& line);

/// A part of the CT, blurred.
CtVolume blurredPart(const CtVolume& ct, const VoxelBox& box, double sigma_mm);

/// Why these are no clicks along a vessel; nothing where they are.
Result<void> checkClicks(const CtVolume& ct, std::span<const Vec3> clicks_mm);

}  // namespace insonate::segmentation
