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
  std::vector<std::string> necks;  ///< built-in ones
  bool speed = true;               ///< times and memory on a CT of 512 x 512 x 300
  bool quick = false;              ///< necks and atlas with one noise
  /// An angiogram of the chest: `ct_cropped.nii.gz`, and the masks of its vessels beside it.
  std::filesystem::path chestCta;
  /// Labels of an atlas and the map that translates and completes them, see caseFromLabels; both or none.
  std::filesystem::path atlas, atlasMap;
};

/// Walls that a mask of a vessel may hold, and a Dice for each.
constexpr std::array kWalls_mm{0.0, 0.5, 1.0, 1.5};
using WallScores = std::array<double, kWalls_mm.size()>;

/// Agreement of a structure found in a CT with the truth.
struct SegmentationScoreRow {
  std::string variant;             ///< of the built-in neck; or `atlas`, `chest CTA`
  std::string contrast;            ///< `native` or `arterial`
  std::optional<double> noise_HU;  ///< what a synthetic CT has
  std::string structure;
  int clicks = 0;  ///< 0: found by itself
  double dice = 0;
  std::optional<double> meanSurface_mm, p95Surface_mm;
  std::optional<double> bar;  ///< the Dice that is aimed at, where there is one
  /// Scores of a mask drawn by others, as the upper limit: a lumen found exactly, alone and with walls around it.
  std::optional<WallScores> exactLumen;
};

/// Time of a tool on a CT of 512 x 512 x 300.
struct SegmentationTimeRow {
  std::string task;
  double voxels = 0;  ///< of its region
  double median_ms = 0, most_ms = 0;
  double cpu_ms = 0;             ///< processor time of all threads, once
  std::optional<double> bar_ms;  ///< for the median
  double silence_ms = 0;         ///< the longest time in which it did not ask whether to go on
};

/// Peak memory of the process while the automatic part runs.
struct SegmentationMemory {
  double peak_MB = 0, bytesPerVoxel = 0;
};

struct SegmentationBench {
  std::vector<SegmentationScoreRow> rows;
  std::vector<SegmentationTimeRow> times;
  std::optional<SegmentationMemory> memory;
  std::vector<std::string> notes;
};

/// Clicks are what an author would make: points on the middle of a vessel, from end to end. Refuses data that is not
/// there or cannot be read; fails when cancelled.
Result<SegmentationBench> runSegmentationBench(const SegmentationBenchPlan& plan, const Progress& progress = {});

nlohmann::json toJson(const SegmentationBench& bench);

/// segmentation.json, segmentation.csv, segmentation-times.csv and segmentation.md; all of them or none.
Result<void> writeSegmentationBench(const SegmentationBench& bench, const std::filesystem::path& folder);

}  // namespace insonate
