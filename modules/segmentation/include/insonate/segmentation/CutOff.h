#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/Region.h>

#include <vector>

namespace insonate {

/// A stroke across the neck of a part of a label, for example of a leak from a vessel.
struct CutStroke {
  std::vector<Vec3> points_mm{};  ///< two or more points, patient space
  Vec3 along{0, 0, 1};  ///< unit vector perpendicular to the slice on which the stroke was drawn, patient space
};

/// Returns the part of a label that a stroke cuts off. The cut is the stroke, extended along `along` to both sides by
/// the smallest distance, up to 20 mm, at which the voxels on its two sides are no longer connected through faces. The
/// side with fewer voxels is returned. Takes time in proportion to this side. Fails if the stroke does not cross the
/// label, does not cut it apart, or separates fewer than five voxels at its edge, and when cancelled.
Result<Selection> partCutOff(const LabelMap& labels, std::uint8_t label, const CutStroke& stroke,
                             const Progress& progress = {});

}  // namespace insonate
