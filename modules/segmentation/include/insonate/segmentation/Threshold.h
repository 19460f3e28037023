#pragma once

#include <insonate/segmentation/LabelEdit.h>
#include <insonate/segmentation/Region.h>

namespace insonate {

/// Selects all voxels of the selection's box whose CT values are in the range. Reuses the memory of `chosen`, so that a
/// preview can follow a slider. The box must lie within the CT.
void threshold(const CtVolume& ct, HuRange range, Selection& chosen);

/// Proposes `label` for the voxels of the box whose CT values are in the range, except changes that the rules forbid.
/// The result is that of threshold(), proposePainting() and removeForbiddenChanges() in turn, but computed in one pass
/// over the CT. Reuses the memory of `into` if `into` already has this box. The box must lie within the CT.
void proposeThreshold(const CtVolume& ct, HuRange range, std::uint8_t label, const EditRules& rules,
                      const LabelMap& labels, const VoxelBox& box, Proposal& into);

/// Removes from a selection the voxels whose CT values are outside the range, e.g. for a brush that is limited to an
/// intensity range.
void removeOutside(const CtVolume& ct, HuRange range, Selection& chosen);

}  // namespace insonate
