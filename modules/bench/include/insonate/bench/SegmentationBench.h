#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// Plan of a segmentation bench. Real data is scored if its folder is given.
struct SegmentationBenchPlan {
  std::vector<std::string> necks;  ///< built-in necks
  bool speed = true;               ///< measure times and memory on a CT of 512 x 512 x 300
  bool quick = false;              ///< use only one noise level for necks and atlas
  /// Folder of an angiogram of the chest: `ct_cropped.nii.gz` and the masks of its vessels.
  std::filesystem::path chestCta;
  /// Labels of an atlas, and the map that translates and completes them, see caseFromLabels; either both or none.
  std::filesystem::path atlas, atlasMap;
};

/// Thicknesses of vessel wall that a mask may include, and a Dice score for each.
constexpr std::array kWalls_mm{0.0, 0.5, 1.0, 1.5};
using WallScores = std::array<double, kWalls_mm.size()>;

/// Agreement of a structure found in a CT with the truth.
struct SegmentationScoreRow {
  std::string variant;             ///< variant of the built-in neck; or `atlas`, `chest CTA`
  std::string contrast;            ///< `native` or `arterial`
  std::optional<double> noise_HU;  ///< noise of a synthetic CT
  std::string structure;
  int clicks = 0;  ///< 0: found automatically
  double dice = 0;
  std::optional<double> meanSurface_mm, p95Surface_mm;
  std::optional<double> bar;  ///< target Dice score, if there is one
  /// Scores of an exactly found lumen, alone and with walls around it, against a mask drawn by others: the upper limit
  /// of the score.
  std::optional<WallScores> exactLumen;
};

/// Time of a tool on a CT of 512 x 512 x 300.
struct SegmentationTimeRow {
  std::string task;
  double voxels = 0;  ///< number of voxels in the tool's region
  double median_ms = 0, most_ms = 0;
  double cpu_ms = 0;             ///< processor time of all threads in one run
  std::optional<double> bar_ms;  ///< target for the median
  double silence_ms = 0;         ///< longest interval between two checks for cancellation
};

/// Peak memory of the process during the automatic part.
struct SegmentationMemory {
  double peak_MB = 0, bytesPerVoxel = 0;
};

struct SegmentationBench {
  std::vector<SegmentationScoreRow> rows;
  std::vector<SegmentationTimeRow> times;
  std::optional<SegmentationMemory> memory;
  std::vector<std::string> notes;
};

/// Runs the benchmark. Clicks are placed as an author would place them: on the middle of a vessel, from end to end.
/// Fails if data is missing or cannot be read, or if cancelled.
Result<SegmentationBench> runSegmentationBench(const SegmentationBenchPlan& plan, const Progress& progress = {});

nlohmann::json toJson(const SegmentationBench& bench);

/// Writes segmentation.json, segmentation.csv, segmentation-times.csv and segmentation.md; either all of them or none.
Result<void> writeSegmentationBench(const SegmentationBench& bench, const std::filesystem::path& folder);

}  // namespace insonate
