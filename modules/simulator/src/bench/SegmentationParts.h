#pragma once

#include <insonate/cases/CtSynthesis.h>
#include <insonate/cases/PatientCase.h>
#include <insonate/simulator/SegmentationBench.h>

namespace insonate::bench {

/// What a row is of: a built-in neck and how its CT was made.
struct NeckScan {
  std::string variant;
  CtContrast contrast = CtContrast::kNative;
  double noise_HU = 10;
};

/// Structures that are found by themselves, then vessels from clicks where there is contrast in them.
Result<std::vector<SegmentationScoreRow>> scoreNeck(const NeckScan& scan, const Progress& progress);

/// Tools on a neck that is resampled to `size` voxels along its axes.
Result<std::vector<SegmentationTimeRow>> timeTools(const std::array<int, 3>& size, const Progress& progress);

}  // namespace insonate::bench
