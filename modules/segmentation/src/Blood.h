#pragma once

#include "Morphology.h"

namespace insonate::segmentation {

/// Blood whose contrast agent makes it as bright as bone: wide, even, and bordered by soft tissue. Empty without such
/// blood, as in a CT without contrast.
struct BrightBlood {
  bool present = false;
  Mask mask;
};
BrightBlood findBrightBlood(const CtVolume& ct, const LabelMap& body, Work& work);

}  // namespace insonate::segmentation
