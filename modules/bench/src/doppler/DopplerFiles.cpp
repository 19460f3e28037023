#include "report/CellTable.h"

#include <insonate/bench/DopplerBench.h>
#include <insonate/core/AtomicFile.h>

#include <nlohmann/json.hpp>

#include <map>

namespace insonate {
namespace {

using bench::Cells;
using bench::fixed;

std::vector<Cells> dopplerCells(const DopplerBench& bench) {
  std::vector<Cells> cells{{"engine", "measure", "condition", "unit", "expected", "measured", "error_%", "limit_%"}};
  for (const DopplerBenchRow& row : bench.rows)
    cells.push_back({row.engine, row.measure, row.condition, row.unit, fixed(row.expected, 1), fixed(row.measured, 1),
                     fixed(row.error_percent, 2), row.limit_percent > 0 ? fixed(row.limit_percent, 0) : ""});
  return cells;
}

std::vector<Cells> costCells(const DopplerBench& bench) {
  std::vector<Cells> cells{{"engine", "device", "threads", "plain_median_ms", "colored_median_ms",
                            "color_stage_median_ms", "plain_min_ms", "colored_min_ms", "color_stage_min_ms"}};
  for (const ColorCost& cost : bench.costs)
    cells.push_back({cost.engine, cost.device, std::to_string(cost.threads), fixed(cost.plain_ms, 2),
                     fixed(cost.colored_ms, 2), fixed(cost.color_ms, 2), fixed(cost.plainMin_ms, 2),
                     fixed(cost.coloredMin_ms, 2), fixed(cost.colorMin_ms, 2)});
  return cells;
}

std::vector<Cells> spectralCells(const SpectralCost& cost) {
  return {{"gate_per_image_ms", "spectrum_ms", "sound_ms", "second_of_spectra_ms"},
          {fixed(cost.hold_ms, 2), fixed(cost.spectrum_ms, 3), fixed(cost.sound_ms, 3), fixed(cost.perSecond_ms, 0)}};
}

}  // namespace

nlohmann::json toJson(const DopplerBench& bench) {
  nlohmann::json rows = nlohmann::json::array(), costs = nlohmann::json::array();
  for (const DopplerBenchRow& row : bench.rows)
    rows.push_back({{"engine", row.engine},
                    {"measure", row.measure},
                    {"condition", row.condition},
                    {"unit", row.unit},
                    {"expected", row.expected},
                    {"measured", row.measured},
                    {"error_percent", row.error_percent},
                    {"limit_percent", row.limit_percent}});
  for (const ColorCost& cost : bench.costs)
    costs.push_back({{"engine", cost.engine},
                     {"device", cost.device},
                     {"threads", cost.threads},
                     {"plain_median_ms", cost.plain_ms},
                     {"colored_median_ms", cost.colored_ms},
                     {"color_ms", cost.color_ms}});
  const nlohmann::json spectral = {{"gate_per_image_ms", bench.spectral.hold_ms},
                                   {"spectrum_ms", bench.spectral.spectrum_ms},
                                   {"sound_ms", bench.spectral.sound_ms},
                                   {"second_of_spectra_ms", bench.spectral.perSecond_ms}};
  return {{"rows", rows}, {"costs", costs}, {"spectral", spectral}, {"notes", bench.notes}};
}

Result<void> writeDopplerBench(const DopplerBench& bench, const std::filesystem::path& folder) {
  if (auto ok = checkBenchFolder(folder); !ok) return ok;
  std::string page = "# Doppler: errors and cost\n\n" + bench::markdown(dopplerCells(bench)) + "\n" +
                     bench::markdown(costCells(bench)) + "\n" + bench::markdown(spectralCells(bench.spectral)) + "\n";
  for (const std::string& note : bench.notes) page += "- " + note + "\n";
  const std::map<std::string, std::string> files{{"doppler.json", toJson(bench).dump(2) + "\n"},
                                                 {"doppler.csv", bench::csv(dopplerCells(bench))},
                                                 {"cost.csv", bench::csv(costCells(bench))},
                                                 {"spectral.csv", bench::csv(spectralCells(bench.spectral))},
                                                 {"doppler.md", page}};
  return writeFolderAtomically(folder, [&](const std::filesystem::path& beside) -> Result<void> {
    for (const auto& [name, text] : files)
      if (auto ok = writeAtomically(beside / name, text); !ok) return ok;
    return {};
  });
}

}  // namespace insonate
