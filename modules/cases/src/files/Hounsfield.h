#pragma once

#include "VolumeFile.h"

namespace insonate {

inline constexpr int kAirHu = -1024;  ///< lowest HU in a case's CT; padding is set to this value

struct HounsfieldCt {
  CtVolume ct;
  std::size_t saturated = 0;  ///< voxels that were above 32767
};

/// Reads a CT on `geometry`, which must have the size that the file states. Values are rounded and limited to int16 HU:
/// not-a-number and everything below -1024 (padding such as -3024) becomes -1024. Appends a sentence to `notes` for
/// each kind of change. Fails as readVolumeBlocks() does, and on several values per voxel.
Result<HounsfieldCt> readHounsfield(const std::filesystem::path& file, const VolumeHeader& header,
                                    const VolumeGeometry& geometry, std::vector<std::string>& notes);

}  // namespace insonate
