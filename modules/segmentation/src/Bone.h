#pragma once

#include "Morphology.h"

namespace insonate::segmentation {

/// Returns bone with its marrow, inside the body (kSoftTissue of findBody()).
Mask findBone(const CtVolume& ct, const LabelMap& body, Work& work);

}  // namespace insonate::segmentation
