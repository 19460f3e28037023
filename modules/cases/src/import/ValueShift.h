#pragma once

#include <insonate/image/Volume.h>

#include <optional>

namespace insonate {

/// Tells whether all values below 0 are padding.
bool hasNothingBelowZero(const CtVolume& ct);

/// Estimates from the CT's histogram the offset that its conversion to HU seems to lack (ImportedCt::likelyShift_HU);
/// no value if none is likely.
std::optional<int> likelyShift(const CtVolume& ct);

}  // namespace insonate
