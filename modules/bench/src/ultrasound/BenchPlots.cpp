#include "ultrasound/BenchPlots.h"

#include <insonate/bench/SvgPlot.h>

#include <algorithm>

namespace insonate::bench {
namespace {

using Row = UltrasoundBenchRow;

/// A dimension of the workload that was varied.
struct Sweep {
  const char *name, *title, *file;
  int Row::*size;
  bool logarithmic;
};

constexpr Sweep kSweeps[]{
    {"scanlines", "Scanlines", "time-scanlines.svg", &Row::scanlines, true},
    {"samples", "Samples per scanline", "time-samples.svg", &Row::samples, true},
    {"elevation planes", "Elevation planes", "time-planes.svg", &Row::elevationPlanes, false},
};

/// Rows that differ from the workload only in this dimension, by increasing size.
std::vector<const Row*> rowsOf(const UltrasoundBench& bench, const Sweep& sweep, const std::string& engine,
                               int threads) {
  const Row& w1 = bench.rows.front();
  std::vector<const Row*> rows;
  for (const Row& row : bench.rows) {
    const bool varied = std::all_of(std::begin(kSweeps), std::end(kSweeps), [&](const Sweep& other) {
      return other.size == sweep.size || row.*other.size == w1.*other.size;
    });
    if (varied && row.look == w1.look && row.engine == engine && row.threads == threads) rows.push_back(&row);
  }
  std::sort(rows.begin(), rows.end(), [&](const Row* a, const Row* b) { return a->*sweep.size < b->*sweep.size; });
  return rows;
}

/// Engine and threads of each kind of row, the reference last.
std::vector<std::pair<std::string, int>> kindsOf(const UltrasoundBench& bench) {
  std::vector<std::pair<std::string, int>> kinds;
  for (const Row& row : bench.rows)
    if (std::pair kind(row.engine, row.threads); std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
      kinds.push_back(kind);
  return kinds;
}

std::string nameOf(const std::pair<std::string, int>& kind) {
  return kind.first + ", " + std::to_string(kind.second) + (kind.second == 1 ? " thread" : " threads");
}

std::string timeAgainstError(const UltrasoundBench& bench) {
  LineChart chart{
      .title = "Speed against error",
      .subtitle = "whole frames with a moving probe; error against a dense reference frame, speckle left out",
      .x = {.title = "median frame time, ms (wall clock)", .logarithmic = true},
      .y = {.title = "discretisation error, % of the envelope's RMS", .logarithmic = true},
      .series = {},
      .levels = {}};
  for (const auto& kind : kindsOf(bench))
    for (const Sweep& sweep : kSweeps) {
      PlotSeries series{.name = kind.first + " x " + std::to_string(kind.second) + ", " + sweep.name,
                        .points = {},
                        .joined = true,
                        .dashed = kind.first == "reference"};
      for (const Row* row : rowsOf(bench, sweep, kind.first, kind.second))
        series.points.push_back(
            {row->times.median_ms, row->discretisationError_percent, std::to_string(row->*sweep.size)});
      chart.series.push_back(std::move(series));
    }
  return svgOf(chart);
}

std::string timeAgainstAgreement(const UltrasoundBench& bench) {
  LineChart chart{.title = "Speed against agreement with the reference engine",
                  .subtitle = "whole frames with a moving probe; both engines at the same settings, speckle on",
                  .x = {.title = "median frame time, ms (wall clock)", .logarithmic = true},
                  .y = {.title = "envelope error, % of its RMS", .logarithmic = true},
                  .series = {},
                  .levels = {{"0.5 % allowed", 0.5}}};
  for (const auto& kind : kindsOf(bench)) {
    if (kind.first == "reference") continue;
    PlotSeries series{.name = nameOf(kind), .points = {}, .joined = false, .dashed = false};
    for (const Row& row : bench.rows)
      if (row.engine == kind.first && row.threads == kind.second && row.look == bench.rows.front().look)
        series.points.push_back({row.times.median_ms, row.envelopeError_percent, ""});
    chart.series.push_back(std::move(series));
  }
  return svgOf(chart);
}

std::string timeAgainstSize(const UltrasoundBench& bench, const Sweep& sweep) {
  LineChart chart{.title = std::string("Frame time against ") + sweep.name,
                  .subtitle = "median of whole frames with a moving probe, wall clock",
                  .x = {.title = sweep.title, .logarithmic = sweep.logarithmic},
                  .y = {.title = "median frame time, ms", .logarithmic = true},
                  .series = {},
                  .levels = {{"plain scalar loop of W1", bench.plainLoop.median_ms}}};
  for (const auto& kind : kindsOf(bench)) {
    PlotSeries series{.name = nameOf(kind), .points = {}, .joined = true, .dashed = kind.first == "reference"};
    for (const Row* row : rowsOf(bench, sweep, kind.first, kind.second))
      series.points.push_back({double(row->*sweep.size), row->times.median_ms, ""});
    chart.series.push_back(std::move(series));
  }
  return svgOf(chart);
}

std::string stageBars(const UltrasoundBench& bench) {
  StackedBars chart{.title = "Stages of workload W1 on processors",
                    .subtitle = "least times of each stage; those of the engine are summed over threads",
                    .valueTitle = "ms",
                    .bars = {},
                    .parts = {}};
  std::vector<int> threads;
  std::vector<StageLimits> stages;
  std::ranges::copy_if(bench.stages, std::back_inserter(stages),
                       [](const StageLimits& stage) { return stage.engine == "cpu"; });
  for (const StageLimits& stage : stages) {
    if (std::find(threads.begin(), threads.end(), stage.threads) == threads.end()) threads.push_back(stage.threads);
    const auto known = std::any_of(chart.parts.begin(), chart.parts.end(),
                                   [&](const StackedBars::Part& part) { return part.name == stage.stage; });
    if (!known) chart.parts.push_back({stage.stage, {}});
  }
  for (const int n : threads) chart.bars.push_back(std::to_string(n) + (n == 1 ? " thread" : " threads"));
  for (StackedBars::Part& part : chart.parts)
    for (const int n : threads)
      for (const StageLimits& stage : stages)
        if (stage.stage == part.name && stage.threads == n) part.values.push_back(stage.time.min_ms);
  return svgOf(chart);
}

}  // namespace

std::map<std::string, std::string> plotsOf(const UltrasoundBench& bench) {
  std::map<std::string, std::string> plots{{"stages.svg", stageBars(bench)}};
  if (bench.rows.empty()) return plots;
  plots["time-error.svg"] = timeAgainstError(bench);
  plots["time-agreement.svg"] = timeAgainstAgreement(bench);
  for (const Sweep& sweep : kSweeps) plots[sweep.file] = timeAgainstSize(bench, sweep);
  return plots;
}

}  // namespace insonate::bench
