#pragma once

#include <insonate/bench/SegmentationBench.h>
#include <insonate/cases/CtSynthesis.h>
#include <insonate/cases/PatientCase.h>

#include <span>

namespace insonate::bench {

using ScoreRows = std::vector<SegmentationScoreRow>;

/// Scores segmentations in CTs synthesized from a patient whose labels are the truth, without and with contrast, for
/// each noise level. Scored are structures found automatically and, in contrast CTs, vessels tracked from clicks.
Result<ScoreRows> scoreTruth(const PatientCase& truth, const std::string& variant, std::span<const double> noises_HU,
                             double resolution_FWHM_mm, const Progress& progress);

/// Scores vessels of an angiogram tracked from clicks, against masks drawn by others.
Result<ScoreRows> scoreChestCta(const std::filesystem::path& folder, const Progress& progress);

/// Times the tools on a neck that is resampled to `size` voxels along its axes.
Result<void> timeTools(const std::array<int, 3>& size, SegmentationBench& bench, const Progress& progress);

}  // namespace insonate::bench
