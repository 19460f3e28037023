#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>

#include <span>

namespace insonate {

// Islands are the pieces of a selection that hang together by the faces of their voxels. All fail when cancelled.

/// The largest ones; all where there are no more than `count`.
Result<Selection> largestIslands(const Selection& of, int count, const Progress& progress = {});

/// Selects islands of at least this volume.
Result<Selection> islandsFrom(const Selection& of, double least_mm3, const Progress& progress = {});

/// Selects the island that contains a point of the patient. Fails if no island contains it.
Result<Selection> islandAt(const Selection& of, Vec3 point_mm, const Progress& progress = {});

/// The largest island gets the first label, the next one the second, ...; further ones stay as they are.
Result<Proposal> splitIslands(const Selection& of, std::span<const std::uint8_t> labels, const Progress& progress = {});

}  // namespace insonate
