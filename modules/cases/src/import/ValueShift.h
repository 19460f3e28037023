#pragma once

#include <insonate/image/Volume.h>

#include <optional>

namespace insonate {

/// Tells whether all values below 0 are padding.
bool hasNothingBelowZero(const CtVolume& ct);

/// Returns ImportedCt::likelyShift_HU, estimated from the histogram.
std::optional<int> likelyShift(const CtVolume& ct);

}  // namespace insonate
