#include "CellTable.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/simulator/SegmentationBench.h>
#include <insonate/simulator/UltrasoundBench.h>

#include <nlohmann/json.hpp>

#include <map>

namespace insonate {
namespace {

using bench::Cells;
using bench::fixed;

std::string orNothing(const std::optional<double>& value) {
  return value ? fixed(*value, 2) : "";
}

std::vector<Cells> scores(const SegmentationBench& results) {
  std::vector<Cells> rows{
      {"variant", "contrast", "noise_HU", "structure", "clicks", "dice", "mean_surface_mm", "p95_surface_mm"}};
  for (const SegmentationScoreRow& r : results.rows)
    rows.push_back({r.variant, r.contrast, fixed(r.noise_HU, 0), r.structure, std::to_string(r.clicks),
                    fixed(r.dice, 3), orNothing(r.meanSurface_mm), orNothing(r.p95Surface_mm)});
  return rows;
}

std::vector<Cells> times(const SegmentationBench& results) {
  std::vector<Cells> rows{{"task", "million_voxels", "median_ms", "most_ms"}};
  for (const SegmentationTimeRow& r : results.times)
    rows.push_back({r.task, fixed(r.voxels * 1e-6, 1), fixed(r.median_ms, 1), fixed(r.most_ms, 1)});
  return rows;
}

nlohmann::json orNull(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
}

}  // namespace

nlohmann::json toJson(const SegmentationBench& results) {
  nlohmann::json rows = nlohmann::json::array(), tasks = nlohmann::json::array();
  for (const SegmentationScoreRow& r : results.rows)
    rows.push_back({{"variant", r.variant},
                    {"contrast", r.contrast},
                    {"noise_HU", r.noise_HU},
                    {"structure", r.structure},
                    {"clicks", r.clicks},
                    {"dice", r.dice},
                    {"mean_surface_mm", orNull(r.meanSurface_mm)},
                    {"p95_surface_mm", orNull(r.p95Surface_mm)}});
  for (const SegmentationTimeRow& r : results.times)
    tasks.push_back({{"task", r.task}, {"voxels", r.voxels}, {"median_ms", r.median_ms}, {"max_ms", r.most_ms}});
  return {{"rows", rows}, {"times", tasks}, {"notes", results.notes}};
}

Result<void> writeSegmentationBench(const SegmentationBench& results, const std::filesystem::path& folder) {
  if (auto ok = checkBenchFolder(folder); !ok) return ok;
  std::map<std::string, std::string> files;
  files["segmentation.json"] = toJson(results).dump(2) + "\n";
  files["segmentation.csv"] = bench::csv(scores(results));
  files["segmentation-times.csv"] = bench::csv(times(results));
  std::string page = "# Segmentation: scores on the built-in necks, and how long tools take\n\n" +
                     bench::markdown(scores(results)) + bench::markdown(times(results));
  for (const std::string& note : results.notes) page += "- " + note + "\n";
  files["segmentation.md"] = page;
  return writeFolderAtomically(folder, [&](const std::filesystem::path& beside) -> Result<void> {
    for (const auto& [name, text] : files)
      if (auto ok = writeAtomically(beside / name, text); !ok) return ok;
    return {};
  });
}

}  // namespace insonate
