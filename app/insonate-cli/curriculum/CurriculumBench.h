#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate::cli {

/// Timing of one query, made by one screen of the window and repeated many times.
struct CurriculumBenchRow {
  std::string screen, query;
  std::size_t rows = 0;  ///< maximum number of rows that the query returned
  int asked = 0;
  double p50_ms = 0, p95_ms = 0, max_ms = 0;
};

struct CurriculumBench {
  int trainees = 0, attempts = 0;  ///< attempts of each trainee
  double filled_s = 0;             ///< time for generating and writing the attempts
  std::vector<CurriculumBenchRow> rows;
  std::vector<std::string> notes;
};

/// Measures the queries on a made-up class of 200 trainees with 500 attempts each (`quick`: 20 with 50), in a new file
/// in the temporary folder. Takes minutes, mostly for writing the attempts one by one. Fails when cancelled.
Result<CurriculumBench> runCurriculumBench(bool quick, const Progress& progress);

nlohmann::json toJson(const CurriculumBench& bench);
/// Writes curriculum.json, curriculum.csv and curriculum.md; on failure none of them.
Result<void> writeCurriculumBench(const CurriculumBench& bench, const std::filesystem::path& folder);

}  // namespace insonate::cli
