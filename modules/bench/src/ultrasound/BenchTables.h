#pragma once

#include <insonate/bench/UltrasoundBench.h>

namespace insonate::bench {

/// Return comma-separated tables with a header line; values that are not finite are empty.
std::string rowsCsv(const UltrasoundBench& bench);
std::string stagesCsv(const UltrasoundBench& bench);
std::string realismCsv(const UltrasoundBench& bench);
std::string penetrationCsv(const UltrasoundBench& bench);

/// Returns the tables and plots as a readable page (Markdown).
std::string indexPage(const UltrasoundBench& bench);

}  // namespace insonate::bench
