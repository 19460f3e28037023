#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// One model with one mesh, on the built-in neck under the linear probe, pressed by about 4 mm.
struct DeformationBenchRow {
  std::string model;
  double mesh_mm = 0;  ///< cells near vessels and face
  int unknowns = 0;
  int threads = 1;  ///< that it may use
  /// `cold`: from rest, until converged. `warm`: pressed in and out by 0.25 mm a frame. `moving`: so, and sliding by
  /// 0.3 mm. `static`: the same question again. `untouched`: the face is off the skin.
  std::string state;
  int frames = 0;
  double median_ms = 0, p95_ms = 0, min_ms = 0;  ///< a whole frame: tissue looked up, solved, seen backwards
  double iterations = 0;                         ///< mean
  /// Against `reference` at the same pose, at tissue in the image outside of vessels. NaN where not compared.
  double displacementRms_mm = 0, displacementMax_mm = 0;
  double forceError_percent = 0;
  double lumenAreaError = 0;  ///< of the vein's area as a share of that at rest
  double memory_MB = 0;       ///< that the model holds after a frame
};

/// Areas of the vessels, as shares of those at rest, while a face presses.
struct CompressionCurve {
  double venousPressure_mmHg = 0;
  struct Point {
    double force_N = 0, indentation_mm = 0, vein = 0, artery = 0;
  };
  std::vector<Point> points;
};

struct DeformationBench {
  std::vector<DeformationBenchRow> rows;
  std::vector<CompressionCurve> curves;
  std::vector<std::string> notes;
};

/// Minutes of work; quick: one mesh, one curve. Fails when cancelled.
Result<DeformationBench> runDeformationBench(bool quick, const Progress& progress = {});

/// rows, curves and notes. Values that are not finite are null.
nlohmann::json toJson(const DeformationBench& bench);

/// deformation.json, deformation.csv, compression.csv, plots as SVG and deformation.md; all of them or none.
Result<void> writeDeformationBench(const DeformationBench& bench, const std::filesystem::path& folder);

}  // namespace insonate
