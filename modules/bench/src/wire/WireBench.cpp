#include "report/CellTable.h"

#include <insonate/bench/UltrasoundBench.h>
#include <insonate/bench/WireBench.h>
#include <insonate/cases/Phantom.h>
#include <insonate/core/AtomicFile.h>
#include <insonate/wire/WireSolver.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>

namespace insonate {
namespace {

constexpr double kConverged_mm = 0.25, kConverged_N = 5e-6;
constexpr int kEvery_mm = 10;

/// A wire at each tenth millimeter of its advance.
struct Advance {
  std::vector<std::vector<Vec3>> shapes;
  std::vector<double> forces_N, times_ms;
  double inserted_mm = 0, unbalanced_N = 0;
  int iterations = 0;
};

WireEntry entryInto(const VesselTree& tree, const Target& target, int angle_deg) {
  const Vec3 along = tree.locate(target.label, target.position_mm).towardHeart;
  const Vec3 inward = normalized(Vec3{0, 1, 0} - along * along.y);
  const double angle = angle_deg * std::numbers::pi / 180;
  return {target.position_mm, along * std::cos(angle) + inward * std::sin(angle), -inward, 0};
}

Advance advanceBy(const VesselTree& tree, const Wire& wire, const WireEntry& entry, const WireSettings& settings,
                  int length_mm) {
  WireSolver solver(tree, wire, settings);
  solver.start(entry);
  Advance advance;
  for (int mm = 1; mm <= length_mm && solver.state().refusal == WireRefusal::None; ++mm) {
    const auto begin = std::chrono::steady_clock::now();
    const WireState& state = solver.advance(1);
    advance.times_ms.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    advance.iterations += state.iterations;
    advance.inserted_mm = state.inserted_mm;
    advance.unbalanced_N = std::max(advance.unbalanced_N, state.unbalanced_N);
    if (mm % kEvery_mm != 0 || state.refusal != WireRefusal::None) continue;
    advance.shapes.emplace_back(solver.nodes_mm().begin(), solver.nodes_mm().end());
    advance.forces_N.push_back(state.resistance_N);
  }
  return advance;
}

/// Distance from a point to a polyline.
double distance_mm(const std::vector<Vec3>& line, Vec3 p) {
  double least = 1e9;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec3 along = line[i] - line[i - 1];
    const double t = std::clamp(dot(p - line[i - 1], along) / dot(along, along), 0.0, 1.0);
    least = std::min(least, norm(p - line[i - 1] - along * t));
  }
  return least;
}

double rms(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return values.empty() ? 0 : std::sqrt(sum / static_cast<double>(values.size()));
}

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

WireBenchRow compared(const Advance& advance, const Advance& converged) {
  WireBenchRow row;
  row.inserted_mm = advance.inserted_mm, row.unbalanced_N = advance.unbalanced_N;
  row.median_ms = percentile(advance.times_ms, 0.5), row.p95_ms = percentile(advance.times_ms, 0.95);
  row.max_ms = percentile(advance.times_ms, 1);
  row.meanIterations = advance.iterations / std::max(1.0, static_cast<double>(advance.times_ms.size()));
  std::vector<double> errors_mm, tips_mm, forces_N;
  const std::size_t count = std::min(advance.shapes.size(), converged.shapes.size());
  for (std::size_t i = 0; i < count; ++i) {
    for (const Vec3& node : advance.shapes[i]) errors_mm.push_back(distance_mm(converged.shapes[i], node));
    tips_mm.push_back(norm(advance.shapes[i].back() - converged.shapes[i].back()));
    forces_N.push_back(advance.forces_N[i] - converged.forces_N[i]);
    row.maxForce_N = std::max(row.maxForce_N, converged.forces_N[i]);
  }
  row.error_mm = rms(errors_mm), row.errorP95_mm = percentile(errors_mm, 0.95);
  row.tipError_mm = rms(tips_mm), row.forceError_N = rms(forces_N);
  return row;
}

std::vector<bench::Cells> cellsOf(const WireBench& bench) {
  std::vector<bench::Cells> rows{{"wire", "angle_deg", "spacing_mm", "inserted_mm", "median_ms", "p95_ms", "max_ms",
                                  "newton_steps", "error_mm", "error_p95_mm", "tip_error_mm", "force_error_N",
                                  "max_force_N", "unbalanced_N"}};
  for (const WireBenchRow& r : bench.rows)
    rows.push_back({r.wire, std::to_string(r.angle_deg), bench::fixed(r.spacing_mm, 2), bench::fixed(r.inserted_mm, 0),
                    bench::fixed(r.median_ms, 3), bench::fixed(r.p95_ms, 3), bench::fixed(r.max_ms, 3),
                    bench::fixed(r.meanIterations, 1), bench::fixed(r.error_mm, 3), bench::fixed(r.errorP95_mm, 3),
                    bench::fixed(r.tipError_mm, 3), bench::fixed(r.forceError_N, 3), bench::fixed(r.maxForce_N, 2),
                    bench::fixed(r.unbalanced_N, 6)});
  return rows;
}

}  // namespace

Result<WireBench> runWireBench(bool quick, const Progress& progress) {
  const auto neck = makePhantom(phantomVariants().front().name, 1, progress);
  if (!neck) return tl::unexpected(neck.error());
  const auto tree = VesselTree::make(neck->manifest.vessels, &neck->labels);
  if (!tree) return tl::unexpected(tree.error());
  WireBench bench;
  const int length_mm = quick ? 60 : 180;
  const std::vector<std::string> names =
      quick ? std::vector<std::string>{"j-tip"} : std::vector<std::string>{"j-tip", "straight", "triple-lumen"};
  const std::vector<int> angles_deg = quick ? std::vector<int>{40} : std::vector<int>{25, 40, 55};
  int done = 0;
  for (const std::string& name : names) {
    const auto wire = loadWire(name);
    if (!wire) return tl::unexpected(wire.error());
    for (const int angle_deg : angles_deg) {
      const double share = done++ / static_cast<double>(names.size() * angles_deg.size());
      if (!report(progress, "Advancing wires", share)) return fail(std::string(kCancelled));
      const WireEntry entry = entryInto(*tree, neck->manifest.targets.front(), angle_deg);
      const WireSettings fine{.spacing_mm = kConverged_mm, .tolerance_N = kConverged_N, .maxIterations = 500};
      const Advance converged = advanceBy(*tree, *wire, entry, fine, length_mm);
      for (const double spacing_mm : {4.0, 2.0, 1.0}) {
        WireSettings settings;
        settings.spacing_mm = spacing_mm;
        WireBenchRow row = compared(advanceBy(*tree, *wire, entry, settings, length_mm), converged);
        row.wire = name, row.spacing_mm = spacing_mm, row.angle_deg = angle_deg;
        bench.rows.push_back(std::move(row));
      }
    }
  }
  bench.notes = {
      "A wire enters the right internal jugular vein of the built-in neck `textbook` toward the heart, in steps of 1 "
      "mm.",
      "Errors are distances from a converged wire (nodes every 0.25 mm, unbalanced forces below 5e-6 N, a step for "
      "every "
      "0.125 mm), at each tenth millimeter. A wire that has snapped to another equilibrium counts in full.",
      "Training uses a spacing of 2 mm."};
  return bench;
}

nlohmann::json toJson(const WireBench& bench) {
  nlohmann::json rows = nlohmann::json::array();
  for (const WireBenchRow& r : bench.rows)
    rows.push_back({{"wire", r.wire},
                    {"angle_deg", r.angle_deg},
                    {"spacing_mm", r.spacing_mm},
                    {"inserted_mm", r.inserted_mm},
                    {"median_ms", r.median_ms},
                    {"p95_ms", r.p95_ms},
                    {"max_ms", r.max_ms},
                    {"newton_steps", r.meanIterations},
                    {"error_mm", r.error_mm},
                    {"error_p95_mm", r.errorP95_mm},
                    {"tip_error_mm", r.tipError_mm},
                    {"force_error_N", r.forceError_N},
                    {"max_force_N", r.maxForce_N},
                    {"unbalanced_N", r.unbalanced_N}});
  return {{"rows", rows}, {"notes", bench.notes}};
}

Result<void> writeWireBench(const WireBench& bench, const std::filesystem::path& folder) {
  if (auto ok = checkBenchFolder(folder); !ok) return ok;
  std::string page =
      "# Wire: time of an advance and error against a converged solution\n\n" + bench::markdown(cellsOf(bench)) + "\n";
  for (const std::string& note : bench.notes) page += "- " + note + "\n";
  const std::map<std::string, std::string> files{
      {"wire.json", toJson(bench).dump(2) + "\n"}, {"wire.csv", bench::csv(cellsOf(bench))}, {"wire.md", page}};
  return writeFolderAtomically(folder, [&](const std::filesystem::path& beside) -> Result<void> {
    for (const auto& [name, text] : files)
      if (auto ok = writeAtomically(beside / name, text); !ok) return ok;
    return {};
  });
}

}  // namespace insonate
