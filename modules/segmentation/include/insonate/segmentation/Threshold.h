#pragma once

#include <insonate/segmentation/Region.h>

namespace insonate {

/// The voxels of the selection's box whose CT is in the range. Uses the selection's memory again, so that a preview can
/// follow a slider. The box lies in the CT.
void threshold(const CtVolume& ct, HuRange range, Selection& chosen);

/// Leaves of the chosen voxels those whose CT is in the range: an intensity-limited brush.
void limitTo(const CtVolume& ct, HuRange range, Selection& chosen);

}  // namespace insonate
