#pragma once

#include <insonate/segmentation/LabelEdit.h>

namespace insonate::segmentation {

/// Replaces, in a proposal, the entries `marker` of voxels whose present label is in `removed` by the label of their
/// surroundings (LabelStep::kSurroundings). Voxels that are connected through faces are one part. Time and memory in
/// proportion to the proposal's box.
void takeSurroundings(const CtVolume& ct, const LabelMap& labels, const LabelSet& removed, std::uint8_t marker,
                      Proposal& proposal);

}  // namespace insonate::segmentation
