#include "report/CellTable.h"

#include <insonate/bench/DeformationBench.h>
#include <insonate/bench/SvgPlot.h>
#include <insonate/bench/UltrasoundBench.h>
#include <insonate/core/AtomicFile.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace insonate {
namespace {

using bench::fixed;
using Row = DeformationBenchRow;

nlohmann::json number(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

struct Column {
  const char* name;
  std::string (*text)(const Row&);
};

constexpr Column kColumns[]{
    {"model", [](const Row& r) { return r.model; }},
    {"mesh_mm", [](const Row& r) { return fixed(r.mesh_mm, 2); }},
    {"unknowns", [](const Row& r) { return std::to_string(r.unknowns); }},
    {"threads", [](const Row& r) { return std::to_string(r.threads); }},
    {"state", [](const Row& r) { return r.state; }},
    {"frames", [](const Row& r) { return std::to_string(r.frames); }},
    {"median_ms", [](const Row& r) { return fixed(r.median_ms, 3); }},
    {"p95_ms", [](const Row& r) { return fixed(r.p95_ms, 3); }},
    {"min_ms", [](const Row& r) { return fixed(r.min_ms, 3); }},
    {"iterations", [](const Row& r) { return fixed(r.iterations, 1); }},
    {"displacement_rms_mm", [](const Row& r) { return fixed(r.displacementRms_mm, 4); }},
    {"displacement_max_mm", [](const Row& r) { return fixed(r.displacementMax_mm, 3); }},
    {"force_error_percent", [](const Row& r) { return fixed(r.forceError_percent, 2); }},
    {"lumen_area_error", [](const Row& r) { return fixed(r.lumenAreaError, 4); }},
    {"memory_MB", [](const Row& r) { return fixed(r.memory_MB, 1); }},
};

std::string table(const std::vector<Row>& rows, const char* begin, const char* between, const char* end) {
  std::string text = begin;
  for (const Column& c : kColumns) text += (&c == kColumns ? "" : between) + std::string(c.name);
  text += end;
  if (*begin == '|') {
    text += "|";
    for (std::size_t k = 0; k < std::size(kColumns); ++k) text += " --- |";
    text += "\n";
  }
  for (const Row& row : rows) {
    text += begin;
    for (const Column& c : kColumns) text += (&c == kColumns ? "" : between) + c.text(row);
    text += end;
  }
  return text;
}

std::string deformationTimeAgainstError(const DeformationBench& bench) {
  LineChart chart{.title = "Deformation: speed against error",
                  .subtitle = "a pressing, sliding probe; error against the converged reference, by mesh",
                  .x = {.title = "median frame time, ms", .logarithmic = true},
                  .y = {.title = "RMS error of the displacement, mm", .logarithmic = true},
                  .series = {},
                  .levels = {{"asked for", 0.05}}};
  for (const char* state : {"moving", "warm", "cold"})
    for (const char* model : {"elastic", "column"}) {
      PlotSeries series{.name = std::string(model) + ", " + state, .points = {}, .joined = true, .dashed = false};
      for (const Row& row : bench.rows)
        if (row.model == model && row.state == state && row.threads == 1)
          series.points.push_back({row.median_ms, row.displacementRms_mm, fixed(row.mesh_mm, 2) + " mm"});
      std::sort(series.points.begin(), series.points.end(),
                [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
      chart.series.push_back(std::move(series));
    }
  return svgOf(chart);
}

std::string areaAgainstForce(const DeformationBench& bench) {
  LineChart chart{.title = "Vessels under the probe",
                  .subtitle = "area against force, by central venous pressure",
                  .x = {.title = "force, N", .logarithmic = false, .fromZero = true},
                  .y = {.title = "area, share of that at rest", .logarithmic = false, .fromZero = true},
                  .series = {},
                  .levels = {}};
  for (const CompressionCurve& curve : bench.curves) {
    const std::string pressure = fixed(curve.venousPressure_mmHg, 0) + " mmHg";
    PlotSeries vein{.name = "vein, " + pressure, .points = {}, .joined = true, .dashed = false};
    PlotSeries artery{.name = "artery, " + pressure, .points = {}, .joined = true, .dashed = true};
    for (const auto& point : curve.points) {
      vein.points.push_back({point.force_N, point.vein, {}});
      artery.points.push_back({point.force_N, point.artery, {}});
    }
    chart.series.push_back(std::move(vein));
    chart.series.push_back(std::move(artery));
  }
  return svgOf(chart);
}

std::string compressionCsv(const DeformationBench& bench) {
  std::string text = "venous_pressure_mmHg,force_N,indentation_mm,vein_area,artery_area\n";
  for (const CompressionCurve& curve : bench.curves)
    for (const auto& p : curve.points)
      text += fixed(curve.venousPressure_mmHg, 1) + "," + fixed(p.force_N, 4) + "," + fixed(p.indentation_mm, 2) + "," +
              fixed(p.vein, 4) + "," + fixed(p.artery, 4) + "\n";
  return text;
}

}  // namespace

nlohmann::json toJson(const DeformationBench& bench) {
  nlohmann::json rows = nlohmann::json::array(), curves = nlohmann::json::array();
  for (const Row& r : bench.rows)
    rows.push_back({{"model", r.model},
                    {"mesh_mm", r.mesh_mm},
                    {"unknowns", r.unknowns},
                    {"threads", r.threads},
                    {"state", r.state},
                    {"frames", r.frames},
                    {"median_ms", r.median_ms},
                    {"p95_ms", r.p95_ms},
                    {"min_ms", r.min_ms},
                    {"iterations", r.iterations},
                    {"displacement_rms_mm", number(r.displacementRms_mm)},
                    {"displacement_max_mm", number(r.displacementMax_mm)},
                    {"force_error_percent", number(r.forceError_percent)},
                    {"lumen_area_error", number(r.lumenAreaError)},
                    {"memory_MB", number(r.memory_MB)}});
  for (const CompressionCurve& c : bench.curves) {
    nlohmann::json points = nlohmann::json::array();
    for (const auto& p : c.points)
      points.push_back({{"force_N", number(p.force_N)},
                        {"indentation_mm", p.indentation_mm},
                        {"vein_area", number(p.vein)},
                        {"artery_area", number(p.artery)}});
    curves.push_back({{"venous_pressure_mmHg", c.venousPressure_mmHg}, {"points", points}});
  }
  return {{"rows", rows}, {"curves", curves}, {"notes", bench.notes}};
}

Result<void> writeDeformationBench(const DeformationBench& bench, const std::filesystem::path& folder) {
  if (auto ok = checkBenchFolder(folder); !ok) return ok;
  std::map<std::string, std::string> files;
  files["deformation.json"] = toJson(bench).dump(2) + "\n";
  files["deformation.csv"] = table(bench.rows, "", ",", "\n");
  files["compression.csv"] = compressionCsv(bench);
  files["deformation-time.svg"] = deformationTimeAgainstError(bench);
  files["compression.svg"] = areaAgainstForce(bench);
  std::string page =
      "# Deformation: speed against error\n\n" + table(bench.rows, "| ", " | ", " |\n") +
      "\n![Speed against error](deformation-time.svg)\n\n![Vessels under the probe](compression.svg)\n\n";
  for (const std::string& note : bench.notes) page += "- " + note + "\n";
  files["deformation.md"] = page;
  return writeFolderAtomically(folder, [&](const std::filesystem::path& beside) -> Result<void> {
    for (const auto& [name, text] : files)
      if (auto ok = writeAtomically(beside / name, text); !ok) return ok;
    return {};
  });
}

}  // namespace insonate
