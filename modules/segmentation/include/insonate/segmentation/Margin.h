#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>

namespace insonate {

// Distances are between the centers of voxels, in millimeters on any grid. The selection's box must leave a margin of
// that distance around the shape. All functions fail when cancelled; the last two refuse a result without voxels.

/// Enlarges a shape by `margin_mm` on all sides.
Result<Selection> grownBy(const Selection& shape, double margin_mm, const Progress& progress = {});
/// Shrinks a shape by `margin_mm` on all sides, except where it touches the edge of the box.
Result<Selection> shrunkBy(const Selection& shape, double margin_mm, const Progress& progress = {});

/// Position of the wall of a hollow shape relative to the surface of the original shape: inside, centered on it, or
/// outside.
enum class Wall { kInside, kMiddle, kOutside };
/// Returns the wall of a shape: a shell of this thickness along the shape's surface.
Result<Selection> makeShell(const Selection& shape, double thickness_mm, Wall wall, const Progress& progress = {});

}  // namespace insonate
