#pragma once

#include <insonate/bench/SvgPlot.h>

#include <string>
#include <vector>

namespace insonate::bench {

/// Axis of an SVG chart: maps values to pixels.
class SvgAxis {
 public:
  struct Tick {
    double value;
    std::string label;
  };
  /// Makes an axis that spans those of the `values` that the axis can show (a logarithmic axis: values above 0), and
  /// that ends on round numbers. `lastPixel` may be less than `firstPixel`.
  SvgAxis(const PlotAxis& axis, const std::vector<double>& values, double firstPixel, double lastPixel);

  bool shows(double value) const;
  double pixel(double value) const;
  const std::vector<Tick>& ticks() const { return ticks_; }

 private:
  void spanDecades(double low, double high);
  void spanSteps(double low, double high);

  bool logarithmic_;
  double first_ = 0, last_ = 1;  // ends of the scale: values, or their logarithms for a logarithmic axis
  double firstPixel_, lastPixel_;
  std::vector<Tick> ticks_;
};

}  // namespace insonate::bench
