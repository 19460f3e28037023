#pragma once

#include <insonate/bench/SegmentationBench.h>
#include <insonate/cases/CtSynthesis.h>
#include <insonate/cases/PatientCase.h>

#include <span>

namespace insonate::bench {

using ScoreRows = std::vector<SegmentationScoreRow>;

/// Scores of a patient whose labels are the truth, in CTs synthesised from them, without contrast and with, for each
/// noise: structures that are found by themselves, and vessels from clicks where there is contrast in them.
Result<ScoreRows> scoreTruth(const PatientCase& truth, const std::string& variant, std::span<const double> noises_HU,
                             double resolution_FWHM_mm, const Progress& progress);

/// Vessels of an angiogram from clicks, against masks that others have drawn.
Result<ScoreRows> scoreChestCta(const std::filesystem::path& folder, const Progress& progress);

/// Times the tools on a neck that is resampled to `size` voxels along its axes.
Result<void> timeTools(const std::array<int, 3>& size, SegmentationBench& bench, const Progress& progress);

}  // namespace insonate::bench
