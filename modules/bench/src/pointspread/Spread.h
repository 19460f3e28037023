#pragma once

#include <insonate/bench/PointSpreadBench.h>

#include <complex>
#include <vector>

namespace insonate::bench {

/// Image of a point: its echo by position across the image and along the beam, and the echo's peak by position across
/// the slice.
struct Spread {
  double x_mm = 0.05, z_mm = 0.01, y_mm = 0.05;  ///< steps
  int across = 0, along = 0;
  std::vector<std::complex<double>> echo;  ///< [across][along], with the point in the middle of both
  std::vector<double> slice;               ///< peak by position across the slice, with the point in the middle
  std::vector<double> endAcross;           ///< peak by position across the image, near the array's end

  std::vector<double> peaksAcross() const;
};

PointSpreadFigures figuresOf(const Spread& spread);

}  // namespace insonate::bench
