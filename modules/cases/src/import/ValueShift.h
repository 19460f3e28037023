#pragma once

#include <insonate/image/Volume.h>

#include <optional>

namespace insonate {

/// Tells whether nothing but padding is below 0.
bool hasNothingBelowZero(const CtVolume& ct);

/// ImportedCt::likelyShift_HU, from the histogram.
std::optional<int> likelyShift(const CtVolume& ct);

}  // namespace insonate
