#pragma once

#include <insonate/bench/UltrasoundBench.h>

namespace insonate::bench {

/// Returns the measured rows as a comma-separated table with a header line, as stagesCsv() and realismCsv() do for
/// stages and realism; values that are not finite are empty.
std::string rowsCsv(const UltrasoundBench& bench);
std::string stagesCsv(const UltrasoundBench& bench);
std::string realismCsv(const UltrasoundBench& bench);
std::string penetrationCsv(const UltrasoundBench& bench);

/// Returns a Markdown page with all tables and plots of the benchmark.
std::string indexPage(const UltrasoundBench& bench);

}  // namespace insonate::bench
