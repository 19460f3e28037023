#pragma once

#include <insonate/bench/UltrasoundBench.h>

namespace insonate::bench {

/// Comma-separated tables with a header line; values that are not finite are left empty.
std::string rowsCsv(const UltrasoundBench& bench);
std::string stagesCsv(const UltrasoundBench& bench);
std::string realismCsv(const UltrasoundBench& bench);

/// The tables and plots as a page for people (Markdown).
std::string indexPage(const UltrasoundBench& bench);

}  // namespace insonate::bench
