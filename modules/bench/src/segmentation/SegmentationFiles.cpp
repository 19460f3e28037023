#include "report/CellTable.h"

#include <insonate/bench/SegmentationBench.h>
#include <insonate/bench/UltrasoundBench.h>
#include <insonate/core/AtomicFile.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <compare>
#include <map>

namespace insonate {
namespace {

using bench::Cells;
using bench::fixed;

constexpr double kMemoryBar = 12;  // bytes a voxel: four times a CT of 16 bits with labels of 8

std::string orNothing(const std::optional<double>& value) {
  return value ? fixed(*value, 2) : "";
}

std::string against(bool met) {
  return met ? "met" : "missed";
}

/// "0 mm 0.810, 0.5 mm 0.860, ...": thickness of a wall, and the Dice of lumen and wall.
std::string withWalls(const std::optional<WallScores>& scores) {
  std::string text;
  for (std::size_t n = 0; scores && n < kWalls_mm.size(); ++n)
    text += (n ? "; " : "") + fixed(kWalls_mm[n], 1) + " mm " + fixed((*scores)[n], 3);
  return text;
}

std::vector<Cells> scores(const SegmentationBench& results) {
  std::vector<Cells> rows{{"variant", "contrast", "noise_HU", "structure", "clicks", "dice", "mean_surface_mm",
                           "p95_surface_mm", "aimed_at", "bar", "exact_lumen_and_wall", "center_mm", "confidence"}};
  for (const SegmentationScoreRow& r : results.rows)
    rows.push_back({r.variant, r.contrast, r.noise_HU ? fixed(*r.noise_HU, 0) : "", r.structure,
                    std::to_string(r.clicks), fixed(r.dice, 3), orNothing(r.meanSurface_mm), orNothing(r.p95Surface_mm),
                    orNothing(r.targetDice), r.targetDice ? against(r.dice >= *r.targetDice) : "",
                    withWalls(r.exactLumen), orNothing(r.center_mm), orNothing(r.confidence)});
  return rows;
}

std::vector<Cells> times(const SegmentationBench& results) {
  std::vector<Cells> rows{
      {"task", "million_voxels", "median_ms", "most_ms", "cpu_ms", "silence_ms", "aimed_at_ms", "bar"}};
  for (const SegmentationTimeRow& r : results.times)
    rows.push_back({r.task, fixed(r.voxels * 1e-6, 1), fixed(r.median_ms, 1), fixed(r.max_ms, 1), fixed(r.cpu_ms, 1),
                    fixed(r.cancelCheckInterval_ms, 1), r.target_ms ? fixed(*r.target_ms, 0) : "",
                    r.target_ms ? against(r.median_ms <= *r.target_ms) : ""});
  return rows;
}

/// Groups the vessels of a kind: `vein 2` counts as `vein`.
std::string kindOf(const SegmentationScoreRow& row) {
  std::string kind = row.structure;
  while (!kind.empty() && (std::isdigit(static_cast<unsigned char>(kind.back())) || kind.back() == ' '))
    kind.pop_back();
  return kind;
}

/// Summary of the synthetic CTs, which readers look for first.
std::vector<Cells> summary(const SegmentationBench& results) {
  struct Key {
    std::string structure;
    int clicks;
    std::string contrast;
    double noise_HU;
    auto operator<=>(const Key&) const = default;
  };
  std::map<Key, std::vector<double>> dice;
  std::map<Key, std::optional<double>> bars;
  for (const SegmentationScoreRow& r : results.rows) {
    if (!r.noise_HU) continue;
    const Key key{kindOf(r), r.clicks, r.contrast, *r.noise_HU};
    dice[key].push_back(r.dice);
    bars[key] = r.targetDice;
  }
  std::vector<Cells> rows{
      {"structure", "clicks", "contrast", "noise_HU", "scores", "least", "median", "aimed_at", "met by"}};
  for (auto& [key, values] : dice) {
    std::ranges::sort(values);
    const auto bar = bars[key];
    const auto met = bar ? std::ranges::count_if(values, [&](double d) { return d >= *bar; }) : 0;
    rows.push_back({key.structure, std::to_string(key.clicks), key.contrast, fixed(key.noise_HU, 0),
                    std::to_string(values.size()), fixed(values.front(), 3), fixed(values[values.size() / 2], 3),
                    orNothing(bar), bar ? std::to_string(met) : ""});
  }
  return rows;
}

nlohmann::json orNull(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
}

nlohmann::json walls(const std::optional<WallScores>& scores) {
  if (!scores) return nullptr;
  nlohmann::json all = nlohmann::json::array();
  for (std::size_t n = 0; n < kWalls_mm.size(); ++n) all.push_back({{"wall_mm", kWalls_mm[n]}, {"dice", (*scores)[n]}});
  return all;
}

std::string pageOf(const SegmentationBench& results) {
  std::string page = "# Segmentation: scores against known truth, and how long tools take\n\n";
  if (!results.rows.empty())
    page += "Synthetic CTs together\n\n" + bench::markdown(summary(results)) + "Each\n\n" +
            bench::markdown(scores(results));
  if (!results.times.empty()) page += bench::markdown(times(results));
  if (const auto& memory = results.memory)
    page += "- Memory of the process during the automatic part: " + fixed(memory->peak_MB, 0) + " MB, " +
            fixed(memory->bytesPerVoxel, 1) +
            " bytes a voxel; aimed at 12 (4 times CT and labels): " + against(memory->bytesPerVoxel <= kMemoryBar) +
            ".\n";
  for (const std::string& note : results.notes) page += "- " + note + "\n";
  return page;
}

}  // namespace

nlohmann::json toJson(const SegmentationBench& results) {
  nlohmann::json rows = nlohmann::json::array(), tasks = nlohmann::json::array();
  for (const SegmentationScoreRow& r : results.rows)
    rows.push_back({{"variant", r.variant},
                    {"contrast", r.contrast},
                    {"noise_HU", orNull(r.noise_HU)},
                    {"structure", r.structure},
                    {"clicks", r.clicks},
                    {"dice", r.dice},
                    {"mean_surface_mm", orNull(r.meanSurface_mm)},
                    {"p95_surface_mm", orNull(r.p95Surface_mm)},
                    {"aimed_at", orNull(r.targetDice)},
                    {"exact_lumen", walls(r.exactLumen)},
                    {"center_mm", orNull(r.center_mm)},
                    {"confidence", orNull(r.confidence)}});
  for (const SegmentationTimeRow& r : results.times)
    tasks.push_back({{"task", r.task},
                     {"voxels", r.voxels},
                     {"median_ms", r.median_ms},
                     {"max_ms", r.max_ms},
                     {"cpu_ms", r.cpu_ms},
                     {"silence_ms", r.cancelCheckInterval_ms},
                     {"aimed_at_ms", orNull(r.target_ms)}});
  nlohmann::json object{{"rows", rows}, {"times", tasks}, {"notes", results.notes}, {"memory", nullptr}};
  if (const auto& memory = results.memory)
    object["memory"] = {
        {"peak_MB", memory->peak_MB}, {"bytes_per_voxel", memory->bytesPerVoxel}, {"aimed_at", kMemoryBar}};
  return object;
}

Result<void> writeSegmentationBench(const SegmentationBench& results, const std::filesystem::path& folder) {
  if (auto ok = checkBenchFolder(folder); !ok) return ok;
  std::map<std::string, std::string> files;
  files["segmentation.json"] = toJson(results).dump(2) + "\n";
  files["segmentation.csv"] = bench::csv(scores(results));
  files["segmentation-times.csv"] = bench::csv(times(results));
  files["segmentation.md"] = pageOf(results);
  return writeFolderAtomically(folder, [&](const std::filesystem::path& beside) -> Result<void> {
    for (const auto& [name, text] : files)
      if (auto ok = writeAtomically(beside / name, text); !ok) return ok;
    return {};
  });
}

}  // namespace insonate
