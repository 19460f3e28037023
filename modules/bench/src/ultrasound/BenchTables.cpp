#include "ultrasound/BenchTables.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace insonate {
namespace {

using nlohmann::json;

json rounded(double value) {
  if (!std::isfinite(value)) return nullptr;
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", value);
  return std::strtod(text, nullptr);
}

void addTimes(json& object, const FrameTimes& times) {
  object["frames"] = times.frames;
  object["median_ms"] = rounded(times.median_ms);
  object["p95_ms"] = rounded(times.p95_ms);
  object["min_ms"] = rounded(times.min_ms);
  object["cpu_ms"] = rounded(times.cpu_ms);
}

json jsonOf(const UltrasoundBenchRow& row) {
  json object{{"engine", row.engine},
              {"threads", row.threads},
              {"scanlines", row.scanlines},
              {"samples", row.samples},
              {"elevation_planes", row.elevationPlanes},
              {"width", row.width},
              {"height", row.height},
              {"look", row.look},
              {"gate_mm", rounded(row.gate_mm)},
              {"envelope_error_percent", rounded(row.envelopeError_percent)},
              {"ssim", rounded(row.ssim)},
              {"discretisation_error_percent", rounded(row.discretisationError_percent)},
              {"discretisation_ssim", rounded(row.discretisationSsim)},
              {"stages_ms", json::object()}};
  addTimes(object, row.times);
  for (const StageTime& stage : row.stages) object["stages_ms"][stage.name] = rounded(stage.median_ms);
  return object;
}

json jsonOf(const StageLimits& s) {
  json object{{"engine", s.engine}, {"stage", s.stage}, {"threads", s.threads}};
  object["median_ms"] = rounded(s.time.median_ms), object["min_ms"] = rounded(s.time.min_ms);
  const auto known = [&](double value) { return s.operations > 0 ? rounded(value) : json(); };
  object["operations"] = known(s.operations), object["bytes"] = known(s.bytes);
  object["gigaoperations_per_s"] = known(s.giga_operationsPerSecond);
  object["gigabytes_per_s"] = known(s.gigabytesPerSecond);
  object["percent_of_arithmetic_peak"] = known(s.percentOfArithmetic);
  object["percent_of_cache_bandwidth"] = known(s.percentOfCache);
  object["percent_of_memory_bandwidth"] = known(s.percentOfMemory);
  return object;
}

json jsonOf(const RealismRow& r) {
  const PixelBox& b = r.box;
  const json box = b.width > 0 ? json{b.column, b.row, b.width, b.height} : json();
  return {{"variant", r.variant}, {"view", r.view},
          {"measure", r.measure}, {"patch", r.patch},
          {"box", box},           {"value", rounded(r.value)},
          {"real_low", r.low},    {"real_median", r.median},
          {"real_high", r.high},  {"in_range", r.inRange}};
}

json jsonOf(const PenetrationRow& r) {
  return {{"machine", r.machine},
          {"probe", r.probe},
          {"frequency_MHz", rounded(r.frequency_MHz)},
          {"expected_mm", rounded(r.expected_mm)},
          {"penetration_mm", rounded(r.penetration_mm)},
          {"harmonic_mm", rounded(r.harmonic_mm)},
          {"loss_dB", rounded(r.loss_dB)}};
}

json jsonOf(const BenchComputer& machine) {
  json limits = json::array();
  for (const BenchComputer::Limits& l : machine.limits)
    limits.push_back({{"threads", l.threads},
                      {"multiply_add_gflops", rounded(l.multiplyAdd_GFLOPs)},
                      {"cache_triad_gb_per_s", rounded(l.cache_GBps)},
                      {"memory_triad_gb_per_s", rounded(l.memory_GBps)}});
  return {{"processor", machine.processor}, {"vectors", machine.vectors}, {"cores", machine.cores}, {"limits", limits}};
}

template <class Rows>
json arrayOf(const Rows& rows) {
  json array = json::array();
  for (const auto& row : rows) array.push_back(jsonOf(row));
  return array;
}

std::string cellOf(const json& value) {
  if (value.is_null()) return "";
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_array()) {
    std::string text;
    for (const json& item : value) text += (text.empty() ? "" : " ") + item.dump();
    return text;
  }
  if (!value.is_string()) return value.dump();
  std::string text = value.get<std::string>();
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2) text.insert(at, 1, '"');
  return '"' + text + '"';
}

/// Keeps the order of the columns, so that tables read from left to right.
std::string csvOf(const json& rows, const std::vector<std::string>& columns) {
  std::string text;
  for (const std::string& column : columns) text += (text.empty() ? "" : ",") + column;
  text += '\n';
  for (const json& row : rows) {
    for (std::size_t c = 0; c < columns.size(); ++c) text += (c ? "," : "") + cellOf(row.at(columns[c]));
    text += '\n';
  }
  return text;
}

}  // namespace

json toJson(const UltrasoundBench& bench) {
  json plainLoop = json::object();
  addTimes(plainLoop, bench.plainLoop);
  return {{"rows", arrayOf(bench.rows)},
          {"stages", arrayOf(bench.stages)},
          {"realism", arrayOf(bench.realism)},
          {"penetration", arrayOf(bench.penetration)},
          {"machine", jsonOf(bench.machine)},
          {"plain_loop", plainLoop},
          {"notes", bench.notes}};
}

namespace bench {

std::string rowsCsv(const UltrasoundBench& results) {
  json rows = arrayOf(results.rows);
  std::vector<std::string> columns{"engine",
                                   "threads",
                                   "scanlines",
                                   "samples",
                                   "elevation_planes",
                                   "width",
                                   "height",
                                   "look",
                                   "gate_mm",
                                   "frames",
                                   "median_ms",
                                   "p95_ms",
                                   "min_ms",
                                   "cpu_ms",
                                   "envelope_error_percent",
                                   "ssim",
                                   "discretisation_error_percent",
                                   "discretisation_ssim"};
  return csvOf(rows, columns);
}

std::string stagesCsv(const UltrasoundBench& results) {
  return csvOf(arrayOf(results.stages), {"engine", "stage", "threads", "median_ms", "min_ms", "operations", "bytes",
                                         "gigaoperations_per_s", "gigabytes_per_s", "percent_of_arithmetic_peak",
                                         "percent_of_cache_bandwidth", "percent_of_memory_bandwidth"});
}

std::string realismCsv(const UltrasoundBench& results) {
  return csvOf(arrayOf(results.realism), {"variant", "view", "measure", "patch", "box", "value", "real_low",
                                          "real_median", "real_high", "in_range"});
}

std::string penetrationCsv(const UltrasoundBench& results) {
  return csvOf(arrayOf(results.penetration),
               {"machine", "probe", "frequency_MHz", "expected_mm", "penetration_mm", "harmonic_mm", "loss_dB"});
}

}  // namespace bench
}  // namespace insonate
