#pragma once

#include <insonate/segmentation/LabelEdit.h>
#include <insonate/segmentation/Region.h>

namespace insonate {

/// Selects the voxels of the selection's box whose CT is in the range. Reuses the selection's memory, so that a preview
/// can follow a slider. The box must lie within the CT.
void threshold(const CtVolume& ct, HuRange range, Selection& chosen);

/// Proposes `label` for the voxels in the range, without the changes that the rules forbid: threshold(), painted() and
/// restrictTo() in one pass over the CT. Reuses the memory of `into` if `into` already has this box. The box must lie
/// within the CT.
void proposeThreshold(const CtVolume& ct, HuRange range, std::uint8_t label, const EditRules& rules,
                      const LabelMap& labels, const VoxelBox& box, Proposal& into);

/// Removes from a selection the voxels whose CT is outside the range, e.g. for an intensity-limited brush.
void removeOutside(const CtVolume& ct, HuRange range, Selection& chosen);

}  // namespace insonate
