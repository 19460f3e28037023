#pragma once

#include "Morphology.h"

#include <optional>

namespace insonate::segmentation {

/// Threshold between air and tissue: half-way between air and the lightest tissue, above the noise of lung.
inline constexpr int kMatter_HU = -400;

/// Labels voxels outside the patient kBackground, air enclosed by the body kAirway, and the rest of the body
/// kSoftTissue. No value if there is no body.
std::optional<LabelMap> findBody(const CtVolume& ct, Work& work);

}  // namespace insonate::segmentation
