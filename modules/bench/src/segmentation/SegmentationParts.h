#pragma once

#include <insonate/bench/SegmentationBench.h>
#include <insonate/cases/CtSynthesis.h>
#include <insonate/cases/PatientCase.h>

#include <span>

namespace insonate::bench {

using ScoreRows = std::vector<SegmentationScoreRow>;

/// Scores segmentations in synthetic CTs, without and with contrast agent, for each noise level. The CTs are computed
/// from the labels of `truth`, which are the reference. Scored are structures found automatically and, with contrast
/// agent, vessels tracked from clicks.
Result<ScoreRows> scoreTruth(const PatientCase& truth, const std::string& variant, std::span<const double> noises_HU,
                             double resolution_FWHM_mm, const Progress& progress);

/// Scores vessels that are tracked from clicks in a real chest CT angiogram, against masks drawn by others.
Result<ScoreRows> scoreChestCta(const std::filesystem::path& folder, const Progress& progress);

/// Scores vessels, thyroid and muscles that are found without clicks in warped built-in necks, and notes how often a
/// high confidence was justified.
Result<void> scoreAutomaticStructures(bool quick, SegmentationBench& bench, const Progress& progress);

/// Measures the times of the segmentation tools on a neck that is resampled to `size` voxels.
Result<void> timeTools(const std::array<int, 3>& size, SegmentationBench& bench, const Progress& progress);

}  // namespace insonate::bench
