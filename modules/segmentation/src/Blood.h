#pragma once

#include "Morphology.h"

namespace insonate::segmentation {

/// Voxels of blood that contrast agent makes as bright as bone. Such blood is wide, even, and bordered by soft tissue.
/// Empty if there is none, as in a CT without contrast agent.
struct BrightBlood {
  bool present = false;
  Mask mask;
};
BrightBlood findBrightBlood(const CtVolume& ct, const LabelMap& body, Work& work);

}  // namespace insonate::segmentation
