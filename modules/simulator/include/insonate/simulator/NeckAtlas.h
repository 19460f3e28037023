#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/NeckProposal.h>

#include <vector>

namespace insonate {

/// Makes the atlas for proposeNeck() from built-in necks: thin and thick, with the head turned to either side, and with
/// veins of different size and place. Takes a few seconds. Fails when cancelled.
Result<std::vector<AtlasNeck>> makeNeckAtlas(const Progress& progress = {});

}  // namespace insonate
