#pragma once

#include "SeriesGroups.h"

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <cstdint>
#include <string>
#include <vector>

namespace insonate {

struct SliceValues {
  std::vector<std::int16_t> hu;  ///< HU of all slices, in the series' order
  std::size_t saturated = 0;     ///< number of values above the range of 16 bits, which were limited to the range
};

/// Decodes every slice of a series, in the series' order, to HU, with each slice's own slope and intercept; padding and
/// everything below -1024 become -1024. Fails on missing or truncated pixels and on formats that a CT does not have.
/// Adds a note for each kind of change.
Result<SliceValues> readSlices(const DicomSeries& series, std::vector<std::string>& notes, const Progress& progress);

}  // namespace insonate
