#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate::cli {

/// A query of a screen to a store, repeated many times.
struct CurriculumBenchRow {
  std::string screen, query;
  std::size_t rows = 0;  ///< that came back, at most
  int asked = 0;
  double p50_ms = 0, p95_ms = 0, max_ms = 0;
};

struct CurriculumBench {
  int trainees = 0, attempts = 0;  ///< attempts of each
  double filled_s = 0;             ///< how long it took to make them up and write them
  std::vector<CurriculumBenchRow> rows;
  std::vector<std::string> notes;
};

/// Over a made-up class of 200 trainees with 500 attempts each, in a new file in the folder for temporary files; quick:
/// 20 with 50. Minutes, most of them to write the attempts one by one. Fails when cancelled.
Result<CurriculumBench> runCurriculumBench(bool quick, const Progress& progress);

nlohmann::json toJson(const CurriculumBench& bench);
/// curriculum.json, curriculum.csv and curriculum.md; all of them or none.
Result<void> writeCurriculumBench(const CurriculumBench& bench, const std::filesystem::path& folder);

}  // namespace insonate::cli
