#pragma once

#include <insonate/bench/UltrasoundBench.h>

#include <map>

namespace insonate::bench {

/// Returns the plots of the ultrasound benchmark: SVG texts by file name.
std::map<std::string, std::string> plotsOf(const UltrasoundBench& bench);

}  // namespace insonate::bench
