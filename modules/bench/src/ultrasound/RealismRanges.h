#pragma once

#include <string_view>

namespace insonate::bench {

/// Median and range of a measure over 15 real B-mode images of the neck from several machines: gray 0 to 255 of the
/// final display, inside the field of view.
struct RealismRange {
  std::string_view measure;
  double low, median, high;
};

inline constexpr RealismRange kRealismRanges[]{
    {"grey p25", 1, 5, 52},
    {"grey p50", 3, 23, 88},
    {"grey p75", 34, 47, 139},
    {"grey p95", 86, 121, 226},
    {"grey p99", 130, 176, 255},
    {"grey mean", 23, 35, 101},
    {"black share", 0, 0.25, 0.57},
    {"black share, upper 60 %", 0, 0.07, 0.39},
    {"bright share", 0, 0.003, 0.08},
    {"saturated share", 0, 0, 0.03},
    {"deep over shallow", 0.02, 0.22, 0.74},
    {"grain axial FWHM, mm", 0.30, 0.36, 0.43},
    {"grain lateral FWHM, mm", 0.59, 0.75, 0.99},
    {"even patch SD", 5, 11.5, 13.5},
    {"even patch SD over mean", 0.12, 0.19, 0.43},
    {"even patch skewness", -0.15, 0.28, 0.57},
    {"muscle mean", 12, 33, 64},
    {"muscle SD over mean", 0.18, 0.37, 0.87},
    {"lumen mean", 2, 8, 22},
    {"lumen SD", 2, 5, 18},
    {"lumen over surroundings", 0.03, 0.12, 0.30},
    {"lumen near minus far wall", -2.5, 2.5, 20},
    {"below a vessel over its sides", 1.35, 2.3, 5.5},
    {"bone or pleura line grey", 162, 189, 206},
    {"line over tissue above", 3.2, 4.3, 5.7},
    {"shadow over tissue above", 0.33, 0.42, 0.52},
    {"air shadow over thyroid", 0.005, 0.05, 0.12},
};

}  // namespace insonate::bench
