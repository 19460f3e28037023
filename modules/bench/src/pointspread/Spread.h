#pragma once

#include <insonate/bench/PointSpreadBench.h>

#include <complex>
#include <vector>

namespace insonate::bench {

/// The image of a point: echo by place across the image and along the beam, and its peak by place across the slice.
struct Spread {
  double x_mm = 0.05, z_mm = 0.01, y_mm = 0.05;  ///< steps
  int across = 0, along = 0;
  std::vector<std::complex<double>> echo;  ///< [across][along], the point in the middle of both
  std::vector<double> slice;               ///< the point in the middle
  std::vector<double> endAcross;           ///< peak by place across the image, near the array's end

  std::vector<double> peaksAcross() const;
};

PointSpreadFigures figuresOf(const Spread& spread);

}  // namespace insonate::bench
