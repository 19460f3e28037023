#pragma once

#include <insonate/bench/UltrasoundBench.h>

#include <map>

namespace insonate::bench {

/// Returns SVG files by name.
std::map<std::string, std::string> plotsOf(const UltrasoundBench& bench);

}  // namespace insonate::bench
