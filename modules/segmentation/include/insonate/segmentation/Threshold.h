#pragma once

#include <insonate/segmentation/LabelEdit.h>
#include <insonate/segmentation/Region.h>

namespace insonate {

/// The voxels of the selection's box whose CT is in the range. Uses the selection's memory again, so that a preview can
/// follow a slider. The box lies in the CT.
void threshold(const CtVolume& ct, HuRange range, Selection& chosen);

/// painted() by the label and restrictTo() of the same, in one pass over the CT and in the proposal's own memory where
/// it has that of the box already. The box lies in the CT.
void proposeThreshold(const CtVolume& ct, HuRange range, std::uint8_t label, const EditRules& rules,
                      const LabelMap& labels, const VoxelBox& box, Proposal& into);

/// Leaves of the chosen voxels those whose CT is in the range: an intensity-limited brush.
void limitTo(const CtVolume& ct, HuRange range, Selection& chosen);

}  // namespace insonate
