#include "report/CellTable.h"

#include <insonate/bench/HapticsBench.h>
#include <insonate/bench/SvgPlot.h>
#include <insonate/bench/UltrasoundBench.h>
#include <insonate/core/AtomicFile.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <map>

namespace insonate {
namespace {

using bench::Cells;
using bench::csv;
using bench::fixed;
using bench::markdown;

std::vector<Cells> ticks(const HapticsBench& bench) {
  std::vector<Cells> rows{{"scenario", "ticks", "p50_us", "p99_us", "p999_us", "max_us", "late_ticks", "wake_p99_us",
                           "wake_max_us", "pictures", "passivity_min_J"}};
  for (const HapticsBenchRow& r : bench.rows)
    rows.push_back({r.scenario, std::to_string(r.ticks), fixed(r.p50_us, 2), fixed(r.p99_us, 2), fixed(r.p999_us, 2),
                    fixed(r.max_us, 2), std::to_string(r.lateTicks), fixed(r.wakeP99_us, 1), fixed(r.wakeMax_us, 1),
                    std::to_string(r.pictures), fixed(r.passivityMin_J, 6)});
  return rows;
}

std::vector<Cells> stiffness(const HapticsBench& bench) {
  std::vector<Cells> rows{{"device", "maker_Npmm", "bound_Npmm", "found_Npmm", "found_account_Npmm"}};
  const auto add = [&rows](const StiffnessRow& r) {
    rows.push_back({r.device, fixed(r.maker, 2), fixed(r.bound, 2), fixed(r.found, 2), fixed(r.foundAccount, 2)});
  };
  add(bench.colgate);
  for (const StiffnessRow& r : bench.stiffness) add(r);
  return rows;
}

/// Published values (the value for the vein is an assumption), with the part of the curve that contains each.
struct Published {
  const char* name;
  double depth_mm, low_N, high_N;
};
/// The ranges of resources/haptics/measured.json; the wall of the vein adds to the muscle in front of it (1 N).
constexpr Published kPublished[]{{"skin, published range", 4.1, 0.5, 4},
                                 {"fat, published range", 7.5, 0.1, 0.8},
                                 {"muscle, published range", 15, 0.4, 2},
                                 {"wall of a vein, estimated range", 20.7, 1.2, 2.5}};

/// A plot of every twentieth of a millisecond is smooth.
constexpr std::size_t kEvery = 20;

std::vector<Cells> depths(const HapticsBench& bench) {
  std::vector<Cells> rows{{"table", "way", "depth_mm", "force_N", "in"}};
  for (const ForceDepthCurve& curve : bench.curves)
    for (std::size_t i = 0; i < curve.points.size(); i += kEvery) {
      const ForceDepthPoint& p = curve.points[i];
      rows.push_back({curve.table, 2 * i < curve.points.size() ? "in" : "out", fixed(p.depth_mm, 2),
                      fixed(p.force_N, 4), std::string(labelTable()[p.in].name)});
    }
  return rows;
}

std::string forceAgainstDepth(const HapticsBench& bench) {
  LineChart chart{.title = "A needle through skin, fat, muscle and a vein, onto bone",
                  .subtitle = "resistance at 5 mm/s; dashed: on the way out",
                  .x = {.title = "depth of the tip below the skin at rest, mm"},
                  .y = {.title = "force along the needle, N"},
                  .series = {},
                  .levels = {}};
  for (const ForceDepthCurve& curve : bench.curves) {
    PlotSeries in{.name = curve.table, .points = {}, .joined = true, .dashed = false, .marked = false};
    PlotSeries out{.name = curve.table + ", out", .points = {}, .joined = true, .dashed = true, .marked = false};
    for (std::size_t i = 0; i < curve.points.size(); i += kEvery)
      (2 * i < curve.points.size() ? in : out)
          .points.push_back({curve.points[i].depth_mm, curve.points[i].force_N, {}});
    chart.series.push_back(std::move(in));
    chart.series.push_back(std::move(out));
  }
  for (const Published& p : kPublished)
    chart.series.push_back({.name = p.name, .points = {{p.depth_mm, p.low_N, {}}, {p.depth_mm, p.high_N, {}}}});
  return svgOf(chart);
}

nlohmann::json toJson(const StiffnessRow& r) {
  return {{"device", r.device},
          {"maker_Npmm", r.maker},
          {"bound_Npmm", r.bound},
          {"found_Npmm", r.found},
          {"found_account_Npmm", r.foundAccount}};
}

}  // namespace

nlohmann::json toJson(const HapticsBench& bench) {
  nlohmann::json rows = nlohmann::json::array(), walls = nlohmann::json::array({toJson(bench.colgate)});
  for (const HapticsBenchRow& r : bench.rows)
    rows.push_back({{"scenario", r.scenario},
                    {"ticks", r.ticks},
                    {"p50_us", r.p50_us},
                    {"p99_us", r.p99_us},
                    {"p999_us", r.p999_us},
                    {"max_us", r.max_us},
                    {"late_ticks", r.lateTicks},
                    {"wake_p99_us", r.wakeP99_us},
                    {"wake_max_us", r.wakeMax_us},
                    {"pictures", r.pictures},
                    {"passivity_min_J", r.passivityMin_J}});
  for (const StiffnessRow& r : bench.stiffness) walls.push_back(toJson(r));
  return {{"rows", rows}, {"stiffness", walls}, {"notes", bench.notes}};
}

Result<void> writeHapticsBench(const HapticsBench& bench, const std::filesystem::path& folder) {
  if (auto ok = checkBenchFolder(folder); !ok) return ok;
  std::map<std::string, std::string> files;
  files["haptics.json"] = toJson(bench).dump(2) + "\n";
  files["haptics.csv"] = csv(ticks(bench));
  files["stiffness.csv"] = csv(stiffness(bench));
  files["force-depth.csv"] = csv(depths(bench));
  files["force-depth.svg"] = forceAgainstDepth(bench);
  std::string page = "# Haptics: the servo's ticks, stability and forces\n\n" + markdown(ticks(bench)) +
                     markdown(stiffness(bench)) + "![Force against depth](force-depth.svg)\n\n";
  for (const std::string& note : bench.notes) page += "- " + note + "\n";
  files["haptics.md"] = page;
  return writeFolderAtomically(folder, [&](const std::filesystem::path& beside) -> Result<void> {
    for (const auto& [name, text] : files)
      if (auto ok = writeAtomically(beside / name, text); !ok) return ok;
    return {};
  });
}

}  // namespace insonate
