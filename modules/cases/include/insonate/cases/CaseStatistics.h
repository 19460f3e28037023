#pragma once

#include <insonate/cases/CaseView.h>
#include <insonate/core/Progress.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace insonate {

/// Statistics of a case's CT and labels.
struct CaseStatistics {
  static constexpr int kLowest_HU = -1024, kHighest_HU = 3071;
  int min_HU = 0, max_HU = 0;  ///< minimum and maximum HU of the CT; may lie beyond the histogram's range
  /// Number of voxels for each HU from kLowest_HU to kHighest_HU. The first and the last entry also count all values
  /// beyond the range.
  std::vector<std::uint64_t> histogram = std::vector<std::uint64_t>(kHighest_HU - kLowest_HU + 1);
  std::array<std::uint64_t, 256> voxels{};  ///< number of voxels of each label
  double voxel_mm3 = 0;

  double volume_ml(std::uint8_t label) const { return static_cast<double>(voxels[label]) * voxel_mm3 / 1000; }
};

/// Computes the statistics in one pass over CT and labels, which must be on one grid. Fails on a case without voxels,
/// and when cancelled.
Result<CaseStatistics> caseStatistics(const CaseView& patient, const Progress& progress = {});

}  // namespace insonate
