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
  std::vector<Cells> cells{
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
      {"most attempts waiting for verification", std::to_string(bench.maxWaiting)},
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
  if (bench.load.withVideo) {
    cells.push_back({"processor time for a minute of video (s)", fixed(bench.videoMinute_s, 0)});
    cells.push_back({"size of a minute of video (MB)", fixed(bench.videoMinute_MB, 1)});
  }
  return cells;
}

std::string page(const ServerBench& bench) {
  return "# Server under load\n\nPages and workstations share the computer with the load generator. Aim: 95 of "
         "100 pages within " +
         fixed(kBar_ms, 0) + " ms, and no acknowledged attempt lost.\n\n" + markdown(requests(bench)) +
         markdown(figures(bench));
}

}  // namespace

nlohmann::json toJson(const ServerBench& bench) {
  nlohmann::json rows = nlohmann::json::array();
  for (const ServerBenchRow& r : bench.rows)
    rows.push_back({{"request", r.request},
                    {"count", r.count},
                    {"failures", r.failures},
                    {"p50_ms", r.p50_ms},
                    {"p95_ms", r.p95_ms},
                    {"p99_ms", r.p99_ms},
                    {"max_ms", r.max_ms}});
  const ServerLoad& load = bench.load;
  return {{"rows", rows},
          {"database", bench.database},
          {"servers", load.servers},
          {"workstations", load.workstations},
          {"readers", load.readers},
          {"live_pages", load.livePages},
          {"trainees", bench.trainees},
          {"classes", bench.classes},
          {"earlier_attempts", bench.earlierAttempts},
          {"attempt_s", bench.recording_s},
          {"recordings_MB", bench.load_MB},
          {"acknowledged", bench.acknowledged},
          {"lost", bench.lost},
          {"verified", bench.verified},
          {"refused", bench.refused},
          {"most_waiting", bench.maxWaiting},
          {"drained_s", bench.drained_s},
          {"events", bench.events},
          {"broken_streams", bench.brokenStreams},
          {"kills", bench.kills},
          {"database_crashes", bench.crashes},
          {"slowest_start_s", bench.slowestStart_s},
          {"load_s", bench.measured_s},
          {"processor_s", bench.processor_s},
          {"verification_processor_s", bench.verification_s},
          {"video_minute_processor_s", bench.videoMinute_s},
          {"video_minute_MB", bench.videoMinute_MB},
          {"memory_MB", bench.memory_MB}};
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
