#pragma once

#include "realism/BlindSet.h"

namespace insonate::bench {

/// Returns the results as a page for a browser: what was compared, which features distinguish the sets, the protocol of
/// the reading test, and all images with their sources. Files are relative to the bench's folder.
std::string realismPage(const RealismBench& bench, const BlindImages& images);

}  // namespace insonate::bench
