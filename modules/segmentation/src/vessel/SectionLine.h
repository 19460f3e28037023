#pragma once

#include <insonate/segmentation/VesselTracking.h>

#include <vector>

namespace insonate::segmentation {

/// Returns the line smoothed by a moving average over `reach` points on both sides. Near an end, fewer points are used,
/// equally many on both sides, so that the ends do not move.
std::vector<Vec3> smoothed(const std::vector<Vec3>& line, int reach);

/// Returns points a millimeter apart on a polyline.
std::vector<Vec3> resampled(const std::vector<Vec3>& line);

/// Returns sections perpendicular to a line. Each section is rotated as little as possible relative to the previous
/// one, so that the ray with number n stays on the same side of the vessel.
std::vector<VesselOutline> sectionsAlong(const std::vector<Vec3>& line);

/// Returns a part of the CT, blurred with a Gaussian.
CtVolume blurredPart(const CtVolume& ct, const VoxelBox& box, double sigma_mm);

/// Fails with the reason if these are not valid clicks along a vessel.
Result<void> checkClicks(const CtVolume& ct, std::span<const Vec3> clicks_mm);

}  // namespace insonate::segmentation
