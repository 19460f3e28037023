#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>

namespace insonate {

// Distances are between the centers of voxels, in millimeters on any grid. The selection's box needs a margin of the
// distance around the shape. All fail when cancelled; the last two refuse to let a shape vanish.

/// Larger by so much on all sides.
Result<Selection> grownBy(const Selection& shape, double margin_mm, const Progress& progress = {});
/// Smaller by so much on all sides; the box's own edge erodes nothing.
Result<Selection> shrunkBy(const Selection& shape, double margin_mm, const Progress& progress = {});

/// Position of a hollow shape's wall.
enum class Wall { kInside, kMiddle, kOutside };
/// The wall of a shape alone: inside its surface, outside it, or half and half.
Result<Selection> hollowed(const Selection& shape, double thickness_mm, Wall wall, const Progress& progress = {});

}  // namespace insonate
