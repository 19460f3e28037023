#pragma once

#include <insonate/image/Volume.h>

#include <atomic>
#include <cstdint>
#include <vector>

namespace insonate::views {

/// Number of voxels by Hounsfield unit, in bins of equal width.
struct HuHistogram {
  double min_HU = -1024, max_HU = 3071;  ///< lower edge of the first bin; upper edge of the last bin; min_HU < max_HU
  std::vector<std::uint64_t> counts;     ///< number of voxels in each bin; empty if there is no CT

  double binWidth_HU() const { return counts.empty() ? 0 : (max_HU - min_HU) / double(counts.size()); }
};

/// Computes the histogram of a CT. The histogram's range includes at least air to dense bone. Beyond that, the range
/// includes the values of the CT within the range of TransferFunction, except that the brightest hundred-thousandth of
/// the voxels (metal, single wrong voxels) may lie above the range. Takes some milliseconds per million voxels: do not
/// call it on the window's thread. Returns an empty histogram if `stop` becomes true during the computation.
HuHistogram huHistogram(const CtVolume& ct, int bins = 256, const std::atomic<bool>* stop = nullptr);

}  // namespace insonate::views
