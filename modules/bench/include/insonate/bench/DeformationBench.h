#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// Measurements of one tissue deformation model with one mesh, on the built-in neck, which the linear probe compresses
/// by about 4 mm.
struct DeformationBenchRow {
  std::string model;
  double mesh_mm = 0;  ///< size of the mesh cells near vessels and the probe's face
  int unknowns = 0;
  int threads = 1;  ///< maximum number of threads
  /// Change of the input between frames. `cold`: each frame is solved from undeformed tissue until the solution
  /// converges. `warm`: the compression changes by 0.25 mm per frame. `moving`: in addition, the probe slides by 0.3 mm
  /// per frame. `static`: the input does not change. `untouched`: the face is off the skin.
  std::string state;
  int frames = 0;
  /// Computing time of a whole frame: sampling of the tissue, solution, and inversion of the displacement.
  double median_ms = 0, p95_ms = 0, min_ms = 0;
  double iterations = 0;  ///< mean number of iterations per frame
  /// RMS and maximum of the difference between this model's displacement and that of the model `reference` at the same
  /// pose, over the tissue in the image except vessels. NaN: not compared.
  double displacementRms_mm = 0, displacementMax_mm = 0;
  double forceError_percent = 0;
  double lumenAreaError = 0;  ///< error of the vein's cross-sectional area, as a fraction of its undeformed area
  double memory_MB = 0;       ///< memory that the model occupies after a frame
};

/// Cross-sectional areas of vein and artery during compression, as fractions of their undeformed areas.
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

/// Runs the deformation benchmark, which takes minutes; `quick`: one mesh and one curve only. Fails if cancelled.
Result<DeformationBench> runDeformationBench(bool quick, const Progress& progress = {});

/// Returns rows, curves and notes as JSON. Values that are not finite are null.
nlohmann::json toJson(const DeformationBench& bench);

/// Writes the results into `folder`: deformation.json, deformation.csv, compression.csv, plots as SVG and
/// deformation.md; either all of them or none.
Result<void> writeDeformationBench(const DeformationBench& bench, const std::filesystem::path& folder);

}  // namespace insonate
