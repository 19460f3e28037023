#pragma once

#include "Morphology.h"

#include <optional>

namespace insonate::segmentation {

/// Threshold of matter: half-way between air and the lightest tissue, apart from the noise of lung.
inline constexpr int kMatter_HU = -400;

/// kBackground outside the patient, kAirway in air that the body encloses, kSoftTissue in the body. Nothing when there
/// is no body.
std::optional<LabelMap> findBody(const CtVolume& ct, Work& work);

}  // namespace insonate::segmentation
