#pragma once

#include <insonate/bench/SvgPlot.h>

#include <string>
#include <vector>

namespace insonate::bench {

/// Values along one side of a chart to pixels.
class SvgAxis {
 public:
  struct Tick {
    double value;
    std::string label;
  };
  /// Spans the `values` that the axis can show and ends on round numbers; pixels may run backwards.
  SvgAxis(const PlotAxis& axis, const std::vector<double>& values, double firstPixel, double lastPixel);

  bool shows(double value) const;
  double pixel(double value) const;
  const std::vector<Tick>& ticks() const { return ticks_; }

 private:
  void spanDecades(double low, double high);
  void spanSteps(double low, double high);

  bool logarithmic_;
  double first_ = 0, last_ = 1;  // of the scale: value, or its logarithm
  double firstPixel_, lastPixel_;
  std::vector<Tick> ticks_;
};

}  // namespace insonate::bench
