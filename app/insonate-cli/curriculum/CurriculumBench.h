#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate::cli {

/// Timing of one database query that a page of the window makes, repeated many times.
struct CurriculumBenchRow {
  std::string screen, query;
  std::size_t rows = 0;  ///< maximum number of rows that the query returned
  int asked = 0;
  double p50_ms = 0, p95_ms = 0, max_ms = 0;
};

struct CurriculumBench {
  int trainees = 0, attempts = 0;  ///< number of trainees, and of attempts of each trainee
  double filled_s = 0;             ///< time for generating the class and writing it to the database
  std::vector<CurriculumBenchRow> rows;
  std::vector<std::string> notes;
};

/// Measures database queries on an invented class of 200 trainees with 500 attempts each (`quick`: 20 with 50), in a
/// new file in the temporary folder. Takes minutes, mostly for writing the attempts one by one. Fails when cancelled.
Result<CurriculumBench> runCurriculumBench(bool quick, const Progress& progress);

nlohmann::json toJson(const CurriculumBench& bench);
/// Writes the results into `folder`: curriculum.json, curriculum.csv and curriculum.md; on failure none of them.
Result<void> writeCurriculumBench(const CurriculumBench& bench, const std::filesystem::path& folder);

}  // namespace insonate::cli
