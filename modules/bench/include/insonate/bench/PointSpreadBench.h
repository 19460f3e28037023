#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/ultrasound/ImagingSettings.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// Properties of an ultrasound beam at one depth, from the amplitude image of a point (point spread function).
/// Contrasts and correlation lengths are those of fully developed speckle with this point spread function.
struct PointSpreadFigures {
  double lateral_mm = 0, lateral20dB_mm = 0;  ///< lateral full widths at half maximum and at -20 dB
  double axial_mm = 0, slice_mm = 0;          ///< axial and elevation (slice) full widths at half maximum
  double endLateral_mm = 0;                   ///< lateral full width at half maximum 1.2 mm from the array's end
  double aside_dB = 0;                        ///< maximum side lobe level, at lateral distances of 2 mm and more
  /// Level in the middle of an anechoic lumen of 4 or 8 mm diameter, relative to the speckle around it.
  double lumen4_dB = 0, lumen8_dB = 0;
  /// Full widths at half maximum of the speckle intensity's autocorrelation.
  double speckleLateral_mm = 0, speckleAxial_mm = 0;
};

struct PointSpreadRow {
  double depth_mm = 0;
  /// properties of the engine's images (`ours`), and of the array's field computed independently (`field`)
  PointSpreadFigures ours, field;
};

struct PointSpreadBench {
  Probe probe;
  ImagingSettings settings;
  std::string engine;
  std::vector<PointSpreadRow> rows;
};

/// Measures the point spread function of an engine: makes images of points at 5 to 45 mm depth under a linear probe in
/// homogeneous tissue without loss, and computes the array's field for comparison (bench/pointspread/ArrayField.h).
/// Takes a minute. Fails if the probe is not linear or the engine is unknown.
Result<PointSpreadBench> runPointSpreadBench(const Probe& probe, std::string_view engine,
                                             const Progress& progress = {});

/// Writes the results into `folder`: pointspread.csv, index.md and plots by depth; either all of them or none.
Result<void> writePointSpreadBench(const PointSpreadBench& bench, const std::filesystem::path& folder);
nlohmann::json toJson(const PointSpreadBench& bench);

}  // namespace insonate
