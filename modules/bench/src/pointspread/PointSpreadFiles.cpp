#include "report/CellTable.h"

#include <insonate/bench/PointSpreadBench.h>
#include <insonate/bench/SvgPlot.h>
#include <insonate/bench/UltrasoundBench.h>
#include <insonate/core/AtomicFile.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace insonate {
namespace {

struct FigureColumn {
  const char* name;
  const char* key;
  double PointSpreadFigures::*member;
  const char* unit;
};
constexpr std::array kFigureColumns{
    FigureColumn{"lateral width", "lateral_mm", &PointSpreadFigures::lateral_mm, "mm"},
    FigureColumn{"lateral width at -20 dB, side lobes included", "lateral20dB_mm", &PointSpreadFigures::lateral20dB_mm,
                 "mm"},
    FigureColumn{"axial width", "axial_mm", &PointSpreadFigures::axial_mm, "mm"},
    FigureColumn{"slice thickness", "slice_mm", &PointSpreadFigures::slice_mm, "mm"},
    FigureColumn{"lateral width 1.2 mm from the array's end", "endLateral_mm", &PointSpreadFigures::endLateral_mm,
                 "mm"},
    FigureColumn{"highest level 2 mm and more aside", "aside_dB", &PointSpreadFigures::aside_dB, "dB"},
    FigureColumn{"highest side lobe", "sideLobe_dB", &PointSpreadFigures::sideLobe_dB, "dB"},
    FigureColumn{"contrast of a lumen of 4 mm", "lumen4_dB", &PointSpreadFigures::lumen4_dB, "dB"},
    FigureColumn{"contrast of a lumen of 8 mm", "lumen8_dB", &PointSpreadFigures::lumen8_dB, "dB"},
    FigureColumn{"speckle across", "speckleLateral_mm", &PointSpreadFigures::speckleLateral_mm, "mm"},
    FigureColumn{"speckle along the beam", "speckleAxial_mm", &PointSpreadFigures::speckleAxial_mm, "mm"},
    FigureColumn{"CNR of a cyst of 4 mm", "cnr4", &PointSpreadFigures::cnr4, "ratio"},
    FigureColumn{"CNR of a cyst of 8 mm", "cnr8", &PointSpreadFigures::cnr8, "ratio"},
    FigureColumn{"gCNR of a cyst of 4 mm", "gcnr4", &PointSpreadFigures::gcnr4, "ratio"},
    FigureColumn{"gCNR of a cyst of 8 mm", "gcnr8", &PointSpreadFigures::gcnr8, "ratio"},
    FigureColumn{"speckle SNR", "speckleSnr", &PointSpreadFigures::speckleSnr, "ratio"}};

constexpr double kNothing_dB = -100;  ///< levels below are those of rounding

bool isLevel(const FigureColumn& column) {
  return std::string_view(column.unit) == "dB";
}

std::string cellOf(const FigureColumn& column, const PointSpreadFigures& figures) {
  const double value = figures.*column.member;
  return isLevel(column) && value < kNothing_dB ? "none" : bench::fixed(value, 2);
}

/// Largest difference over the depths at which both are above rounding: a share of the field's figure, or dB.
std::string worstOf(const PointSpreadBench& bench, const FigureColumn& column) {
  double worst = -1;
  for (const PointSpreadRow& row : bench.rows) {
    const double ours = row.ours.*column.member, field = row.field.*column.member;
    if (isLevel(column) && std::min(ours, field) < kNothing_dB) continue;
    worst = std::max(worst, std::abs(isLevel(column) ? ours - field : 100 * (ours - field) / field));
  }
  return worst < 0 ? "no data" : bench::fixed(worst, 2) + (isLevel(column) ? " dB" : " %");
}

std::string pointSpreadPage(const PointSpreadBench& bench) {
  std::string text = "# The image of a point\n\nProbe " + bench.probe.name + ", " +
                     bench::fixed(bench.settings.frequency_MHz, 2) + " MHz, transmit focus " +
                     bench::fixed(bench.settings.focus_mm, 2) + " mm, engine " + bench.engine +
                     ", homogeneous tissue without loss. Each cell: the engine / the array's field, summed over "
                     "elements, their height and frequencies (Garcia 2022). Widths are full widths at half maximum of "
                     "the amplitude. CNR, gCNR (Rodriguez-Molares 2020) and speckle SNR are measured on "
                     "speckle with anechoic cysts, without noise; full contrast has a CNR of 1.91 and a gCNR of 1, "
                     "fully developed speckle an SNR of 1.91. None: below -100 dB.\n\n| |";
  for (const PointSpreadRow& row : bench.rows) text += " " + std::to_string(int(row.depth_mm)) + " mm |";
  text += " largest difference |\n|---|";
  for (std::size_t n = 0; n <= bench.rows.size(); ++n) text += "---|";
  text += "\n";
  for (const FigureColumn& column : kFigureColumns) {
    text += "| " + std::string(column.name) + ", " + column.unit + " |";
    for (const PointSpreadRow& row : bench.rows)
      text += " " + cellOf(column, row.ours) + " / " + cellOf(column, row.field) + " |";
    text += " " + worstOf(bench, column) + " |\n";
  }
  return text + "\nPlots: `widths.svg`, `levels.svg`, `ratios.svg`.\n";
}

std::string figureTable(const PointSpreadBench& bench) {
  std::string text = "depth_mm,of";
  for (const FigureColumn& column : kFigureColumns) text += "," + std::string(column.key);
  text += "\n";
  for (const PointSpreadRow& row : bench.rows)
    for (const auto* figures : {&row.ours, &row.field}) {
      text += bench::fixed(row.depth_mm, 2) + (figures == &row.ours ? "," + bench.engine : ",field");
      for (const FigureColumn& column : kFigureColumns) text += "," + bench::fixed(figures->*column.member, 2);
      text += "\n";
    }
  return text;
}

std::string plot(const PointSpreadBench& bench, const char* unit) {
  LineChart chart;
  const std::string_view kind(unit);
  chart.title = kind == "mm"   ? "Widths of a point's image"
                : kind == "dB" ? "Levels beside a point's image"
                               : "Speckle and anechoic cysts";
  chart.subtitle = "lines: engine " + bench.engine + "; dashed: the array's field";
  chart.x.title = "depth, mm", chart.y.title = unit;
  chart.y.fromZero = true;
  for (const FigureColumn& column : kFigureColumns) {
    if (std::string_view(column.unit) != unit) continue;
    PlotSeries ours{.name = column.name, .points = {}},
        field{.name = std::string(column.name) + ", field", .points = {}, .dashed = true};
    for (const PointSpreadRow& row : bench.rows) {
      ours.points.push_back({row.depth_mm, row.ours.*column.member, {}});
      field.points.push_back({row.depth_mm, row.field.*column.member, {}});
    }
    chart.series.push_back(std::move(ours));
    chart.series.push_back(std::move(field));
  }
  return svgOf(chart);
}

}  // namespace

Result<void> writePointSpreadBench(const PointSpreadBench& bench, const std::filesystem::path& folder) {
  if (auto ok = checkBenchFolder(folder); !ok) return ok;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return fail("Could not make the folder " + folder.string() + ": " + error.message() + ".");
  if (auto ok = writeAtomically(folder / "widths.svg", plot(bench, "mm")); !ok) return ok;
  if (auto ok = writeAtomically(folder / "levels.svg", plot(bench, "dB")); !ok) return ok;
  if (auto ok = writeAtomically(folder / "ratios.svg", plot(bench, "ratio")); !ok) return ok;
  if (auto ok = writeAtomically(folder / "pointspread.csv", figureTable(bench)); !ok) return ok;
  return writeAtomically(folder / "index.md", pointSpreadPage(bench));
}

nlohmann::json toJson(const PointSpreadBench& bench) {
  nlohmann::json json{{"probe", bench.probe.name}, {"engine", bench.engine}, {"rows", nlohmann::json::array()}};
  for (const PointSpreadRow& row : bench.rows) {
    nlohmann::json one{{"depth_mm", row.depth_mm}};
    for (const FigureColumn& column : kFigureColumns) {
      one["ours"][column.key] = row.ours.*column.member;
      one["field"][column.key] = row.field.*column.member;
    }
    json["rows"].push_back(std::move(one));
  }
  return json;
}

}  // namespace insonate
