#include "report/CellTable.h"

#include <insonate/bench/HandsBench.h>
#include <insonate/bench/UltrasoundBench.h>
#include <insonate/core/AtomicFile.h>

#include <nlohmann/json.hpp>

#include <map>

namespace insonate {
namespace {

using bench::fixed;

std::vector<bench::Cells> errorsOf(const HandsBench& bench) {
  std::vector<bench::Cells> rows{{"condition", "image", "speed mm/s", "tip corners mm", "tip mm", "tip p95 mm",
                                  "direction corners deg", "direction deg", "probe corners mm", "probe mm",
                                  "seen corners %", "seen %"}};
  for (const HandsBenchRow& r : bench.rows)
    rows.push_back({r.condition, std::to_string(r.width) + " x " + std::to_string(r.height), fixed(r.speed_mmps, 0),
                    fixed(r.corners.tip_mm, 2), fixed(r.intensities.tip_mm, 3), fixed(r.intensities.tipP95_mm, 3),
                    fixed(r.corners.direction_deg, 2), fixed(r.intensities.direction_deg, 3),
                    fixed(r.corners.probe_mm, 2), fixed(r.intensities.probe_mm, 3), fixed(100 * r.corners.seen, 0),
                    fixed(100 * r.intensities.seen, 0)});
  return rows;
}

std::vector<bench::Cells> timesOf(const HandsBench& bench) {
  std::vector<bench::Cells> rows{
      {"condition", "jitter mm", "computing ms", "share of a core %", "lag ms", "latency ms"}};
  for (const HandsBenchRow& r : bench.rows)
    rows.push_back({r.condition, r.jitter_mm > 0 ? fixed(r.jitter_mm, 3) : "", fixed(r.cost_ms, 1),
                    fixed(100 * r.core, 0), fixed(r.lag_ms, 1), fixed(r.latency_ms, 1)});
  return rows;
}

nlohmann::json jsonOf(const HandsBenchErrors& e) {
  return {{"tip_mm", e.tip_mm},
          {"tip_p95_mm", e.tipP95_mm},
          {"direction_deg", e.direction_deg},
          {"probe_mm", e.probe_mm},
          {"seen", e.seen}};
}

}  // namespace

nlohmann::json toJson(const HandsBench& bench) {
  nlohmann::json rows = nlohmann::json::array();
  for (const HandsBenchRow& r : bench.rows)
    rows.push_back({{"condition", r.condition},
                    {"width", r.width},
                    {"height", r.height},
                    {"frames", r.frames},
                    {"speed_mmps", r.speed_mmps},
                    {"corners", jsonOf(r.corners)},
                    {"intensities", jsonOf(r.intensities)},
                    {"jitter_mm", r.jitter_mm},
                    {"cost_ms", r.cost_ms},
                    {"core", r.core},
                    {"lag_ms", r.lag_ms},
                    {"latency_ms", r.latency_ms}});
  return {{"rows", rows}, {"notes", bench.notes}};
}

Result<void> writeHandsBench(const HandsBench& bench, const std::filesystem::path& folder) {
  if (auto ok = checkBenchFolder(folder); !ok) return ok;
  std::string page = "# Camera hands: errors and time\n\n" + bench::markdown(errorsOf(bench)) + "\n" +
                     bench::markdown(timesOf(bench)) + "\n";
  for (const std::string& note : bench.notes) page += "- " + note + "\n";
  const std::map<std::string, std::string> files{
      {"hands.json", toJson(bench).dump(2) + "\n"}, {"hands.csv", bench::csv(errorsOf(bench))}, {"hands.md", page}};
  return writeFolderAtomically(folder, [&](const std::filesystem::path& beside) -> Result<void> {
    for (const auto& [name, text] : files)
      if (auto ok = writeAtomically(beside / name, text); !ok) return ok;
    return {};
  });
}

}  // namespace insonate
