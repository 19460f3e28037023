#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// Load for insonate-server: workstations that send attempts, people who read pages, and number of open browser pages
/// that are updated live during the load. Each workstation sends one attempt; the attempts are spread evenly over the
/// duration.
struct ServerLoad {
  std::filesystem::path server{};  ///< file of insonate-server
  /// Empty database (postgresql://...); "": a new SQLite file.
  std::string database{};
  int servers = 1;  ///< number of server processes, which share the database and the folder of recordings
  int workstations = 500;
  int trainees = 500;  ///< number of trainees of the site; at least one for each workstation
  double duration_s = 3600;
  double recording_MB = 8;
  int readers = 50;     ///< number of people who read; each of them reads one page every 5 s
  int livePages = 200;  ///< number of open browser pages that are updated live during the load
  int kills = 0;        ///< number of times that a server process is killed and started again, spread over the duration
  bool withVideo = false;  ///< true: also measures what the video of an attempt costs, after the load
  /// Command for the shell that crashes the database and starts it again, carried out after every second kill; "":
  /// none.
  std::string crashDatabase{};
};

/// Times of one kind of request.
struct ServerBenchRow {
  std::string request{};
  std::int64_t count = 0, failures = 0;  ///< failures: no answer, or a status of 500 and above
  double p50_ms = 0, p95_ms = 0, p99_ms = 0, max_ms = 0;
};

struct ServerBench {
  ServerLoad load{};
  std::string database{};  ///< kind of the database: "SQLite" or "PostgreSQL"
  int trainees = 0, classes = 0, earlierAttempts = 0;
  std::vector<ServerBenchRow> rows{};
  std::int64_t acknowledged = 0;  ///< number of attempts of which the server has told a workstation that it has them
  std::int64_t lost = 0;          ///< acknowledged attempts that are missing, or whose recording is missing
  std::int64_t verified = 0;      ///< number of attempts whose results the server computed again and confirmed
  std::int64_t refused = 0;       ///< number of attempts whose results differ when the server computes them again
  std::int64_t maxWaiting = 0;    ///< largest number of attempts that waited for verification
  double drained_s = 0;           ///< time from the end of the load until no attempt waited for verification
  std::int64_t events = 0;        ///< number of changes that live pages were told of
  std::int64_t brokenStreams = 0;
  int kills = 0, crashes = 0;  ///< numbers of kills of a server process, and of crashes of the database
  double slowestStart_s = 0;   ///< longest time from the start of a server that was killed to its first answer
  double measured_s = 0, processor_s = 0;  ///< duration of the load, and processor time of the servers in it
  double memory_MB = 0;                    ///< largest resident memory of a server process
  double load_MB = 0;                      ///< total size of the recordings that workstations sent to the server
  double recording_s = 0;                  ///< duration of an attempt
  double verification_s = 0;               ///< processor time to compute one attempt again
  /// Processor time and size for a minute of an attempt's video; 0: not measured.
  double videoMinute_s = 0, videoMinute_MB = 0;
};

/// Makes an invented site with 25 trainees in each class, starts the servers and applies the load. Takes the duration
/// of the load, and time to prepare the recordings (about half a second each). Needs twice the size of all recordings
/// in the folder for temporary files. Fails if a server does not start, if the database is not empty, or if cancelled.
Result<ServerBench> runServerBench(const ServerLoad& load, const Progress& progress = {});

nlohmann::json toJson(const ServerBench& bench);

/// Writes the results into `folder`: server.json, server.csv and server.md; either all of them or none.
Result<void> writeServerBench(const ServerBench& bench, const std::filesystem::path& folder);

}  // namespace insonate
