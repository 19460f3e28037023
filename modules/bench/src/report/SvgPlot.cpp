#include "report/SvgAxis.h"

#include <insonate/bench/SvgPlot.h>
#include <insonate/core/Words.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string_view>

namespace insonate {
namespace {

using bench::SvgAxis;

constexpr double kWidth = 900, kHeight = 520;
constexpr double kLeft = 84, kRight = 630, kTop = 74, kBottom = 452;  // margins of the chart; the legend is on its
                                                                      // right
// Colors of Okabe and Ito, distinguishable for color-blind readers and in gray, and two darker ones.
constexpr std::string_view kColors[]{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00",
                                     "#56b4e9", "#7a5c00", "#444444", "#8a2be2"};

using Pixel = std::pair<double, double>;

/// Collects the SVG elements of a drawing.
class Canvas {
 public:
  Canvas(std::string_view title, std::string_view subtitle, double height = kHeight) {
    out_ << std::fixed << std::setprecision(1);
    out_ << R"(<svg xmlns="http://www.w3.org/2000/svg" width=")" << kWidth << "\" height=\"" << height
         << "\" viewBox=\"0 0 " << kWidth << ' ' << height
         << "\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"13\" fill=\"#222\">\n"
         << R"(<rect width="100%" height="100%" fill="#fff"/>)" << '\n';
    text(kLeft, 30, title, "font-size=\"18\" font-weight=\"bold\"");
    text(kLeft, 50, subtitle, "fill=\"#555\"");
  }
  void text(double x, double y, std::string_view words, std::string_view style = "") {
    if (!words.empty())
      out_ << "<text x=\"" << x << "\" y=\"" << y << "\" " << style << '>' << escapedMarkup(words) << "</text>\n";
  }
  void line(double x1, double y1, double x2, double y2, std::string_view style) {
    out_ << "<line x1=\"" << x1 << "\" y1=\"" << y1 << "\" x2=\"" << x2 << "\" y2=\"" << y2 << "\" " << style << "/>\n";
  }
  void box(double x, double y, double width, double height, std::string_view style) {
    out_ << "<rect x=\"" << x << "\" y=\"" << y << "\" width=\"" << width << "\" height=\"" << height << "\" " << style
         << "/>\n";
  }
  void mark(double x, double y, std::string_view color) {
    out_ << "<circle cx=\"" << x << "\" cy=\"" << y << "\" r=\"4\" fill=\"" << color << "\" stroke=\"#fff\"/>\n";
  }
  void path(const std::vector<Pixel>& points, std::string_view color, bool dashed) {
    out_ << "<polyline fill=\"none\" stroke=\"" << color << "\" stroke-width=\"2\""
         << (dashed ? " stroke-dasharray=\"6 4\"" : "") << " points=\"";
    for (const auto& [x, y] : points) out_ << x << ',' << y << ' ';
    out_ << "\"/>\n";
  }
  std::string finished() const { return out_.str() + "</svg>\n"; }

 private:
  std::ostringstream out_;
};

constexpr std::string_view kGrid = "stroke=\"#e2e2e2\"", kFrame = "fill=\"none\" stroke=\"#888\"",
                           kCenterd = "text-anchor=\"middle\"", kFlushRight = "text-anchor=\"end\"",
                           kSmall = "font-size=\"11\" fill=\"#444\"";

void drawTicksBelow(Canvas& canvas, const SvgAxis& axis, double bottom) {
  for (const SvgAxis::Tick& tick : axis.ticks()) {
    canvas.line(axis.pixel(tick.value), kTop, axis.pixel(tick.value), bottom, kGrid);
    canvas.text(axis.pixel(tick.value), bottom + 18, tick.label, kCenterd);
  }
}

void drawTicksLeft(Canvas& canvas, const SvgAxis& axis) {
  for (const SvgAxis::Tick& tick : axis.ticks()) {
    canvas.line(kLeft, axis.pixel(tick.value), kRight, axis.pixel(tick.value), kGrid);
    canvas.text(kLeft - 8, axis.pixel(tick.value) + 4, tick.label, kFlushRight);
  }
}

/// Labels that would overlap those in `taken` are left out.
void drawSeries(Canvas& canvas, const PlotSeries& series, const SvgAxis& x, const SvgAxis& y, std::string_view color,
                std::vector<Pixel>& taken) {
  std::vector<Pixel> at;
  std::vector<std::string_view> labels;
  for (const PlotPoint& point : series.points) {
    if (!x.shows(point.x) || !y.shows(point.y)) continue;
    at.emplace_back(x.pixel(point.x), y.pixel(point.y));
    labels.emplace_back(point.label);
  }
  if (series.joined && at.size() > 1) canvas.path(at, color, series.dashed);
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (series.marked) canvas.mark(at[i].first, at[i].second, color);
    const bool free = std::none_of(taken.begin(), taken.end(), [&](const auto& other) {
      return std::abs(other.first - at[i].first) < 26 && std::abs(other.second - at[i].second) < 12;
    });
    if (!free || labels[i].empty()) continue;
    taken.push_back(at[i]);
    canvas.text(at[i].first + 6, at[i].second - 6, labels[i], kSmall);
  }
}

/// The legend's line of a series: colors repeat after nine, with dashes to distinguish them.
void drawKey(Canvas& canvas, const PlotSeries& series, double row, std::string_view color) {
  if (series.joined) canvas.path({{kRight + 12, row - 4}, {kRight + 36, row - 4}}, color, series.dashed);
  if (series.marked) canvas.mark(kRight + 24, row - 4, color);
  canvas.text(kRight + 44, row, series.name);
}

std::string_view colorOf(std::size_t index) {
  return kColors[index % std::size(kColors)];
}

}  // namespace

std::string svgOf(const LineChart& chart) {
  std::vector<double> xs, ys;
  for (const PlotSeries& series : chart.series)
    for (const PlotPoint& point : series.points)
      if (std::isfinite(point.x) && std::isfinite(point.y)) xs.push_back(point.x), ys.push_back(point.y);
  const bool empty = xs.empty();
  for (const PlotLevel& level : chart.levels) ys.push_back(level.y);
  const SvgAxis x(chart.x, xs, kLeft, kRight), y(chart.y, ys, kBottom, kTop);

  Canvas canvas(chart.title, chart.subtitle);
  drawTicksBelow(canvas, x, kBottom);
  drawTicksLeft(canvas, y);
  canvas.box(kLeft, kTop, kRight - kLeft, kBottom - kTop, kFrame);
  canvas.text((kLeft + kRight) / 2, kBottom + 44, chart.x.title, kCenterd);
  canvas.text(0, 0, chart.y.title, "text-anchor=\"middle\" transform=\"translate(24,263) rotate(-90)\"");
  if (empty) canvas.text((kLeft + kRight) / 2, (kTop + kBottom) / 2, "nothing to show", kCenterd);
  for (const PlotLevel& level : chart.levels) {
    if (!y.shows(level.y)) continue;
    canvas.line(kLeft, y.pixel(level.y), kRight, y.pixel(level.y), "stroke=\"#b00020\" stroke-dasharray=\"3 3\"");
    canvas.text(kRight - 6, y.pixel(level.y) - 5, level.name, "text-anchor=\"end\" font-size=\"11\" fill=\"#b00020\"");
  }
  std::vector<Pixel> taken;  // positions of labels
  for (std::size_t s = 0; s < chart.series.size(); ++s) {
    drawSeries(canvas, chart.series[s], x, y, colorOf(s), taken);
    drawKey(canvas, chart.series[s], kTop + 12 + 22 * double(s), colorOf(s));
  }
  return canvas.finished();
}

std::string svgOf(const StackedBars& chart) {
  constexpr double kBarLeft = 210, kStep = 46, kBar = 28;
  const auto valueOf = [](const StackedBars::Part& part, std::size_t bar) {
    const double value = bar < part.values.size() ? part.values[bar] : 0;
    return std::isfinite(value) ? std::max(value, 0.0) : 0.0;
  };
  std::vector<double> sums(chart.bars.size(), 0.0);
  for (const StackedBars::Part& part : chart.parts)
    for (std::size_t bar = 0; bar < sums.size(); ++bar) sums[bar] += valueOf(part, bar);
  const SvgAxis x({.title = chart.valueTitle, .fromZero = true}, sums, kBarLeft, kRight);
  const double bottom = kTop + 12 + kStep * double(chart.bars.size());
  const double legendBottom = kTop + 22 * double(chart.parts.size());

  Canvas canvas(chart.title, chart.subtitle, std::max(bottom + 64, legendBottom + 24));
  drawTicksBelow(canvas, x, bottom);
  canvas.text((kBarLeft + kRight) / 2, bottom + 44, chart.valueTitle, kCenterd);
  for (std::size_t bar = 0; bar < chart.bars.size(); ++bar) {
    const double top = kTop + 12 + kStep * double(bar);
    canvas.text(kBarLeft - 8, top + kBar / 2 + 4, chart.bars[bar], kFlushRight);
    double sum = 0;
    for (std::size_t p = 0; p < chart.parts.size(); ++p) {
      const double from = x.pixel(sum);
      sum += valueOf(chart.parts[p], bar);
      canvas.box(from, top, x.pixel(sum) - from, kBar, "stroke=\"#fff\" fill=\"" + std::string(colorOf(p)) + "\"");
    }
  }
  if (chart.bars.empty()) canvas.text((kBarLeft + kRight) / 2, kTop + 8, "nothing to show", kCenterd);
  for (std::size_t p = 0; p < chart.parts.size(); ++p) {
    const double row = kTop + 12 + 22 * double(p);
    canvas.box(kRight + 18, row - 11, 12, 12, "fill=\"" + std::string(colorOf(p)) + "\"");
    canvas.text(kRight + 36, row, chart.parts[p].name);
  }
  return canvas.finished();
}

}  // namespace insonate
