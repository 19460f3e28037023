#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// How well a structure of a built-in neck is found in its CT.
struct SegmentationScoreRow {
  std::string variant, contrast;  ///< `native` or `arterial`
  double noise_HU = 0;
  std::string structure;
  int clicks = 0;  ///< 0: found by itself
  double dice = 0;
  std::optional<double> meanSurface_mm, p95Surface_mm;  ///< not of single vessels
};

/// How long a tool takes on a CT of 512 x 512 x 300.
struct SegmentationTimeRow {
  std::string task;
  double voxels = 0;  ///< of its region
  double median_ms = 0, most_ms = 0;
};

struct SegmentationBench {
  std::vector<SegmentationScoreRow> rows;
  std::vector<SegmentationTimeRow> times;
  std::vector<std::string> notes;
};

/// All variants of the built-in neck and a CT of full size; quick: one variant, and no times. Clicks are what an
/// author would make: points on the middle of a vessel, from end to end. Fails when cancelled.
Result<SegmentationBench> runSegmentationBench(bool quick, const Progress& progress = {});

nlohmann::json toJson(const SegmentationBench& bench);

/// segmentation.json, segmentation.csv, segmentation-times.csv and segmentation.md; all of them or none.
Result<void> writeSegmentationBench(const SegmentationBench& bench, const std::filesystem::path& folder);

}  // namespace insonate
