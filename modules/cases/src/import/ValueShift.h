#pragma once

#include <insonate/image/Volume.h>

#include <optional>

namespace insonate {

/// Where nothing is below 0 but padding.
bool hasNothingBelowZero(const CtVolume& ct);

/// ImportedCt::likelyShift_HU, from the histogram.
std::optional<int> likelyShift(const CtVolume& ct);

}  // namespace insonate
