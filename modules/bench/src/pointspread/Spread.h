#pragma once

#include <insonate/bench/PointSpreadBench.h>

#include <complex>
#include <vector>

namespace insonate::bench {

/// Point spread function: echo of a point by lateral and axial position, and the echo's peak by elevation position
/// (across the slice).
struct Spread {
  double x_mm = 0.05, z_mm = 0.01, y_mm = 0.05;  ///< sampling steps: lateral, axial, elevation
  int across = 0, along = 0;
  /// ^Complex echo by position, in the order [lateral][axial]; the point is in the middle of both.
  std::vector<std::complex<double>> echo;
  std::vector<double> slice;      ///< peak of the echo by elevation position; the point is in the middle
  std::vector<double> endAcross;  ///< peak of the echo by lateral position, for a point near the array's end

  std::vector<double> peaksAcross() const;
};

PointSpreadFigures figuresOf(const Spread& spread);

}  // namespace insonate::bench
