#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/views/TransferFunction.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace insonate::views {

/// A grid of Hounsfield units that rays walk through, with the range of values in each of its blocks, so that blocks of
/// which nothing is seen are stepped over. Looks at voxels that others own.
struct CastGrid {
  static constexpr int kShift = 3;  ///< blocks of 8 voxels along a side, and the first of the next block

  struct Range {
    std::int16_t least = 0, most = 0;
  };

  std::array<int, 3> size{};
  std::array<int, 3> blocks{};
  const std::int16_t* voxels = nullptr;
  std::vector<Range> ranges;
  Transform indexFromPatient;
  double finest_mm = 1;  ///< the smallest distance of neighbors

  std::size_t block(int i, int j, int k) const { return (std::size_t(k) * blocks[1] + j) * blocks[0] + i; }
};

/// A patient's CT for casting rays: itself, and a copy of few voxels for images that must be quick.
struct CastVolume {
  /// Maximum size of the copy along a side.
  static constexpr int kMostCoarse = 128;

  std::shared_ptr<const PatientCase> patient;
  std::vector<std::int16_t> copy;
  CastGrid fine, coarse;
};

/// Makes a volume; takes a tenth of a second for a large CT, on the caller's thread.
std::shared_ptr<const CastVolume> makeCastVolume(std::shared_ptr<const PatientCase> patient);

/// A patient's CT as a transfer function shows it, made ready for rays. Nothing of it changes any more.
struct CastLook {
  struct Entry {
    float red = 0, green = 0, blue = 0;  ///< 0..1
    float opacity = 0;                   ///< of a step
  };
  static constexpr int kEntries = 4096, kFirst_HU = -1024;
  static int entryOf(int hu);

  struct Level {
    double step_mm = 1;
    std::vector<Entry> entries;
    std::vector<std::uint8_t> seen;  ///< by block: whether anything in it is
  };

  CastLook(std::shared_ptr<const CastVolume> volume, const TransferFunction& function);

  std::shared_ptr<const CastVolume> volume;
  Level fine, coarse;
};

}  // namespace insonate::views
