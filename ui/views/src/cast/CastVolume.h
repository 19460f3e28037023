#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/views/TransferFunction.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace insonate::views {

/// A grid of Hounsfield units for ray casting, with the range of values in each block, so that rays skip blocks without
/// visible values. Does not own the voxels.
struct CastGrid {
  static constexpr int kShift = 3;  ///< a block is 8 voxels along each axis, plus the first voxel of the next block

  struct Range {
    std::int16_t least = 0, most = 0;
  };

  std::array<int, 3> size{};
  std::array<int, 3> blocks{};
  const std::int16_t* voxels = nullptr;
  std::vector<Range> ranges;
  Transform indexFromPatient;
  double finest_mm = 1;  ///< smallest distance between neighboring voxels

  std::size_t block(int i, int j, int k) const { return (std::size_t(k) * blocks[1] + j) * blocks[0] + i; }
};

/// A patient's CT for ray casting, with a copy at low resolution for images that must be drawn fast.
struct CastVolume {
  /// Maximum number of voxels of the copy along an axis.
  static constexpr int kMaxCoarse = 128;

  std::shared_ptr<const PatientCase> patient;
  std::vector<std::int16_t> copy;
  CastGrid fine, coarse;
};

/// Makes a volume on the caller's thread; takes a tenth of a second for a large CT.
std::shared_ptr<const CastVolume> makeCastVolume(std::shared_ptr<const PatientCase> patient);

/// A patient's CT with a transfer function, prepared for ray casting. The object is constant.
struct CastLook {
  struct Entry {
    float red = 0, green = 0, blue = 0;  ///< components of the color, 0 to 1
    float opacity = 0;                   ///< opacity of one step along the ray
  };
  static constexpr int kEntries = 4096, kFirst_HU = -1024;
  static int entryOf(int hu);

  struct Level {
    double step_mm = 1;
    std::vector<Entry> entries;
    std::vector<std::uint8_t> seen;  ///< for each block: nonzero if the block contains visible values
  };

  CastLook(std::shared_ptr<const CastVolume> volume, const TransferFunction& function);

  std::shared_ptr<const CastVolume> volume;
  Level fine, coarse;
};

}  // namespace insonate::views
