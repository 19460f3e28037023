#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>

#include <span>

namespace insonate {

// Islands are the connected components of a selection, joined by faces of voxels. All functions fail when cancelled.

/// Selects the `count` largest islands (connected components of the selection); all islands if there are no more than
/// that.
Result<Selection> largestIslands(const Selection& of, int count, const Progress& progress = {});

/// Selects the islands (connected components of the selection) of at least this volume.
Result<Selection> islandsOfMinimumVolume(const Selection& of, double min_mm3, const Progress& progress = {});

/// Selects the island (connected component of the selection) that contains a point in patient space. Fails if no island
/// contains the point.
Result<Selection> islandAt(const Selection& of, Vec3 point_mm, const Progress& progress = {});

/// Gives the largest island (connected component of the selection) the first label, the next largest the second, and so
/// on; further islands are not changed.
Result<Proposal> splitIslands(const Selection& of, std::span<const std::uint8_t> labels, const Progress& progress = {});

}  // namespace insonate
