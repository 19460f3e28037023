#pragma once

#include "NeckFit.h"

namespace insonate::segmentation {

/// Finds the thyroid or a muscle where the fitted necks have it: voxels that most of the necks have, and that the CT
/// shows as connected with these. Sets voxels, confidence and ask_mm of `to`.
void proposeTissue(const CtVolume& ct, const StructureShares& shares, ProposedStructure& to, Work& work);

}  // namespace insonate::segmentation
