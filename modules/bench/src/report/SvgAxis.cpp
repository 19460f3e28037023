#include "report/SvgAxis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace insonate::bench {
namespace {

std::string shortNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace

SvgAxis::SvgAxis(const PlotAxis& axis, const std::vector<double>& values, double firstPixel, double lastPixel)
    : logarithmic_(axis.logarithmic), firstPixel_(firstPixel), lastPixel_(lastPixel) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const double v : values)
    if (shows(v)) low = std::min(low, v), high = std::max(high, v);
  if (low > high) low = logarithmic_ ? 1 : 0, high = logarithmic_ ? 10 : 1;
  if (!logarithmic_ && axis.fromZero) low = std::min(low, 0.0);
  logarithmic_ ? spanDecades(low, high) : spanSteps(low, high);
}

bool SvgAxis::shows(double value) const {
  return std::isfinite(value) && (!logarithmic_ || value > 0);
}

double SvgAxis::pixel(double value) const {
  const double at = logarithmic_ ? std::log10(value) : value;
  return firstPixel_ + (at - first_) / (last_ - first_) * (lastPixel_ - firstPixel_);
}

void SvgAxis::spanDecades(double low, double high) {
  first_ = std::log10(low / 1.25), last_ = std::log10(high * 1.25);
  const bool few = last_ - first_ < 2.5;
  for (int decade = static_cast<int>(std::floor(first_)); decade <= last_; ++decade)
    for (const double step : {1.0, 2.0, 5.0}) {
      const double at = decade + std::log10(step);
      if (at < first_ || at > last_ || (!few && step != 1)) continue;
      const double value = step * std::pow(10, decade);
      ticks_.push_back({value, shortNumber(value)});
    }
}

void SvgAxis::spanSteps(double low, double high) {
  if (high <= low) high = low + std::max(1.0, std::abs(low));
  const double rough = (high - low) / 5, decade = std::pow(10, std::floor(std::log10(rough)));
  double step = decade;
  for (const double s : {1.0, 2.0, 2.5, 5.0, 10.0})
    if (s * decade <= rough * 1.5) step = s * decade;
  first_ = std::floor(low / step) * step, last_ = std::ceil(high / step) * step;
  for (int i = 0; first_ + i * step <= last_ + step / 2; ++i)
    ticks_.push_back({first_ + i * step, shortNumber(first_ + i * step)});
}

}  // namespace insonate::bench
