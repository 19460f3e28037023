#pragma once

#include "VolumeFile.h"

namespace insonate {

inline constexpr int kAirHu = -1024;  ///< lowest HU in a case's CT; padding is set to this value

/// Rounds and limits raw values to int16 HU: not-a-number and everything below -1024 (padding such as -3024) becomes
/// -1024. Appends a sentence to `notes` for each kind of change. `geometry` must have the size of `raw`.
Result<CtVolume> toHounsfield(const RawVolume& raw, const VolumeGeometry& geometry, std::vector<std::string>& notes);

}  // namespace insonate
