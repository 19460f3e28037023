#pragma once

#include <insonate/image/Volume.h>

#include <atomic>
#include <cstdint>
#include <vector>

namespace insonate::views {

/// Number of voxels by Hounsfield unit, in bins of equal width.
struct HuHistogram {
  double least_HU = -1024, most_HU = 3071;  ///< lower edge of the first bin, upper edge of the last; least < most
  std::vector<std::uint64_t> counts;        ///< empty where there is no CT

  double binWidth_HU() const { return counts.empty() ? 0 : (most_HU - least_HU) / double(counts.size()); }
};

/// Counts a CT. The range is that of its voxels within TransferFunction's, but for the brightest hundred-thousandth
/// (metal, and single wrong voxels), and never less than air to dense bone. Takes some milliseconds for each million
/// voxels: call it off the window's thread. Empty when `stop` became true meanwhile.
HuHistogram huHistogram(const CtVolume& ct, int bins = 256, const std::atomic<bool>* stop = nullptr);

}  // namespace insonate::views
