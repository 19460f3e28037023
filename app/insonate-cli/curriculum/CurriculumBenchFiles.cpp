#include "CurriculumBench.h"

#include <insonate/bench/UltrasoundBench.h>
#include <insonate/core/AtomicFile.h>
#include <insonate/curriculum/Csv.h>

#include <nlohmann/json.hpp>

#include <cstdio>

namespace insonate::cli {
namespace {

constexpr double kBar_ms = 200;  // so that a screen is there at once

std::string fixed(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

std::vector<std::vector<std::string>> cells(const CurriculumBench& bench) {
  std::vector<std::vector<std::string>> rows{
      {"screen", "query", "rows", "asked", "p50_ms", "p95_ms", "max_ms", "within_bar"}};
  for (const CurriculumBenchRow& r : bench.rows)
    rows.push_back({r.screen, r.query, std::to_string(r.rows), std::to_string(r.asked), fixed(r.p50_ms),
                    fixed(r.p95_ms), fixed(r.max_ms), r.p95_ms <= kBar_ms ? "yes" : "no"});
  return rows;
}

std::string page(const CurriculumBench& bench) {
  std::string text =
      "# Curriculum: what screens ask of the store\n\nBar: 95 of 100 within " + fixed(kBar_ms) + " ms.\n\n";
  const auto rows = cells(bench);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += "|";
    for (const std::string& cell : rows[i]) text += " " + cell + " |";
    text += "\n";
    if (i > 0) continue;
    for (std::size_t column = 0; column < rows[0].size(); ++column) text += "|---";
    text += "|\n";
  }
  text += "\n";
  for (const std::string& note : bench.notes) text += "- " + note + "\n";
  return text;
}

}  // namespace

nlohmann::json toJson(const CurriculumBench& bench) {
  nlohmann::json rows = nlohmann::json::array();
  for (const CurriculumBenchRow& r : bench.rows)
    rows.push_back({{"screen", r.screen},
                    {"query", r.query},
                    {"rows", r.rows},
                    {"asked", r.asked},
                    {"p50_ms", r.p50_ms},
                    {"p95_ms", r.p95_ms},
                    {"max_ms", r.max_ms},
                    {"within_bar", r.p95_ms <= kBar_ms}});
  return {{"trainees", bench.trainees},
          {"attempts", bench.attempts},
          {"filled_s", bench.filled_s},
          {"bar_ms", kBar_ms},
          {"rows", rows},
          {"notes", bench.notes}};
}

Result<void> writeCurriculumBench(const CurriculumBench& bench, const std::filesystem::path& folder) {
  if (auto ok = checkBenchFolder(folder); !ok) return ok;
  return writeFolderAtomically(folder, [&](const std::filesystem::path& beside) -> Result<void> {
    if (auto ok = writeAtomically(beside / "curriculum.json", toJson(bench).dump(2) + "\n"); !ok) return ok;
    if (auto ok = writeAtomically(beside / "curriculum.csv", csvText(cells(bench))); !ok) return ok;
    return writeAtomically(beside / "curriculum.md", page(bench));
  });
}

}  // namespace insonate::cli
