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

/// Data and extent of the segmentation benchmark. Real data are used only if their folder is given.
struct SegmentationBenchPlan {
  std::vector<std::string> necks;  ///< names of built-in necks
  bool speed = true;               ///< true: times and memory are measured on a CT of 512 x 512 x 300
  bool automatic = false;          ///< true: vessels, thyroid and muscles are found without clicks in warped necks
  bool quick = false;              ///< true: only one noise level is used for necks and atlas
  /// Folder of an angiogram of the chest: `ct_cropped.nii.gz` and the masks of its vessels.
  std::filesystem::path chestCta;
  /// Label map of an atlas, and the table that converts its labels (see caseFromLabels); either both or none.
  std::filesystem::path atlas, atlasMap;
};

/// Thicknesses of the vessel wall that a reference mask may include.
constexpr std::array kWalls_mm{0.0, 0.5, 1.0, 1.5};
using WallScores = std::array<double, kWalls_mm.size()>;

/// Agreement of a structure segmented in a CT with the reference labels.
struct SegmentationScoreRow {
  std::string variant;             ///< data: variant of the built-in neck, or `atlas`, `chest CTA`
  std::string contrast;            ///< contrast phase of the CT: `native` or `arterial`
  std::optional<double> noise_HU;  ///< noise of a synthetic CT; empty: real CT
  std::string structure;
  int clicks = 0;  ///< number of clicks from which the structure was tracked; 0: found automatically
  double dice = 0;
  std::optional<double> meanSurface_mm, p95Surface_mm;
  std::optional<double> targetDice;  ///< Dice score that the method should reach; empty: no target
  /// Upper limits of `dice` for a reference mask that may include the vessel wall: Dice scores of the exact lumen,
  /// without and with walls of kWalls_mm, against the mask.
  std::optional<WallScores> exactLumen;
  std::optional<double> center_mm{};   ///< mean distance between found and true center line
  std::optional<double> confidence{};  ///< confidence of a structure that was found automatically (proposeNeck())
};

/// Time of a tool on a CT of 512 x 512 x 300.
struct SegmentationTimeRow {
  std::string task;
  double voxels = 0;  ///< number of voxels in the region that the tool processes
  double median_ms = 0, max_ms = 0;
  double cpu_ms = 0;                  ///< processor time of all threads in one run
  std::optional<double> target_ms;    ///< target for median_ms
  double cancelCheckInterval_ms = 0;  ///< longest interval between two checks for cancellation
};

/// Peak memory of the process during automatic segmentation.
struct SegmentationMemory {
  double peak_MB = 0, bytesPerVoxel = 0;
};

struct SegmentationBench {
  std::vector<SegmentationScoreRow> rows;
  std::vector<SegmentationTimeRow> times;
  std::optional<SegmentationMemory> memory;
  std::vector<std::string> notes;
};

/// Runs the segmentation benchmark. Clicks are placed as a user would place them: on the middle of a vessel, from end
/// to end. Fails if data is missing or cannot be read, or if cancelled.
Result<SegmentationBench> runSegmentationBench(const SegmentationBenchPlan& plan, const Progress& progress = {});

nlohmann::json toJson(const SegmentationBench& bench);

/// Writes the results into `folder`: segmentation.json, segmentation.csv, segmentation-times.csv and segmentation.md;
/// either all of them or none.
Result<void> writeSegmentationBench(const SegmentationBench& bench, const std::filesystem::path& folder);

}  // namespace insonate
