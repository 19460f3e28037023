#include "report/CellTable.h"

#include <insonate/bench/ServerBench.h>
#include <insonate/bench/UltrasoundBench.h>
#include <insonate/core/AtomicFile.h>

#include <nlohmann/json.hpp>

#include <map>

namespace insonate {
namespace {

using bench::Cells;
using bench::csv;
using bench::fixed;
using bench::markdown;

constexpr double kBar_ms = 100;

std::vector<Cells> requests(const ServerBench& bench) {
  std::vector<Cells> rows{{"request", "count", "failures", "p50_ms", "p95_ms", "p99_ms", "max_ms"}};
  for (const ServerBenchRow& r : bench.rows)
    rows.push_back({r.request, std::to_string(r.count), std::to_string(r.failures), fixed(r.p50_ms, 1),
                    fixed(r.p95_ms, 1), fixed(r.p99_ms, 1), fixed(r.max_ms, 1)});
  return rows;
}

std::vector<Cells> figures(const ServerBench& bench) {
  const ServerLoad& load = bench.load;
  return {
      {"figure", "value"},
      {"database", bench.database},
      {"server processes", std::to_string(load.servers)},
      {"trainees; classes; earlier attempts", std::to_string(bench.trainees) + "; " + std::to_string(bench.classes) +
                                                  "; " + std::to_string(bench.earlierAttempts)},
      {"workstations, one attempt each", std::to_string(load.workstations)},
      {"attempts per hour", fixed(3600.0 * load.workstations / bench.measured_s, 0)},
      {"duration of an attempt (s)", fixed(bench.recording_s, 0)},
      {"size of all recordings (MB)", fixed(bench.load_MB, 0)},
      {"readers; live pages", std::to_string(load.readers) + "; " + std::to_string(load.livePages)},
      {"acknowledged attempts", std::to_string(bench.acknowledged)},
      {"lost attempts", std::to_string(bench.lost)},
      {"verified; refused attempts", std::to_string(bench.verified) + "; " + std::to_string(bench.refused)},
      {"most attempts waiting for verification", std::to_string(bench.mostWaiting)},
      {"from the end of the load to the last verification (s)", fixed(bench.drained_s, 1)},
      {"changes told to live pages; broken streams",
       std::to_string(bench.events) + "; " + std::to_string(bench.brokenStreams)},
      {"kills of servers; crashes of the database", std::to_string(bench.kills) + "; " + std::to_string(bench.crashes)},
      {"slowest start of a server (s)", fixed(bench.slowestStart_s, 2)},
      {"duration of the load (s)", fixed(bench.measured_s, 0)},
      {"processor time of the servers (s)", fixed(bench.processor_s, 1)},
      {"share of one core (%)", fixed(100 * bench.processor_s / bench.measured_s, 1)},
      {"processor time to compute one attempt again (s)", fixed(bench.verification_s, 2)},
      {"largest memory of a server process (MB)", fixed(bench.memory_MB, 0)}};
}

std::string page(const ServerBench& bench) {
  std::string text =
      "# Server under load\n\nPages and workstations share the computer with the load generator. Aim: 95 of "
      "100 pages within " +
      fixed(kBar_ms, 0) + " ms, and no acknowledged attempt lost.\n\n" + markdown(requests(bench)) +
      markdown(figures(bench));
  for (const std::string& note : bench.notes) text += "- " + note + "\n";
  return text;
}

}  // namespace

nlohmann::json toJson(const ServerBench& bench) {
  nlohmann::json rows = nlohmann::json::array(), values = nlohmann::json::object();
  for (const ServerBenchRow& r : bench.rows)
    rows.push_back({{"request", r.request},
                    {"count", r.count},
                    {"failures", r.failures},
                    {"p50_ms", r.p50_ms},
                    {"p95_ms", r.p95_ms},
                    {"p99_ms", r.p99_ms},
                    {"max_ms", r.max_ms}});
  const auto cells = figures(bench);
  for (std::size_t i = 1; i < cells.size(); ++i) values[cells[i][0]] = cells[i][1];
  return {{"rows", rows}, {"figures", values}, {"notes", bench.notes}};
}

Result<void> writeServerBench(const ServerBench& bench, const std::filesystem::path& folder) {
  if (auto ok = checkBenchFolder(folder); !ok) return ok;
  const std::map<std::string, std::string> files{
      {"server.json", toJson(bench).dump(2) + "\n"}, {"server.csv", csv(requests(bench))}, {"server.md", page(bench)}};
  return writeFolderAtomically(folder, [&](const std::filesystem::path& beside) -> Result<void> {
    for (const auto& [name, text] : files)
      if (auto ok = writeAtomically(beside / name, text); !ok) return ok;
    return {};
  });
}

}  // namespace insonate
