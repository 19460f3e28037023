#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/ultrasound/ImagingSettings.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// Figures of a beam from the image of a point at one depth, by amplitude. Contrasts and correlation lengths are those
/// that fully developed speckle has with this point spread.
struct PointSpreadFigures {
  double lateral_mm = 0, lateral20dB_mm = 0;  ///< full widths at half maximum and at -20 dB
  double axial_mm = 0, slice_mm = 0;          ///< full widths at half maximum
  double endLateral_mm = 0;                   ///< as lateral_mm, 1.2 mm from the array's end
  double aside_dB = 0;                        ///< highest level 2 mm and more aside
  double lumen4_dB = 0, lumen8_dB = 0;        ///< middle of a lumen of 4 and 8 mm across, against its surroundings
  double speckleLateral_mm = 0, speckleAxial_mm = 0;  ///< full width at half maximum of the intensity's correlation
};

struct PointSpreadRow {
  double depth_mm = 0;
  PointSpreadFigures ours, field;  ///< of the engine, and of the array's field summed independently
};

struct PointSpreadBench {
  Probe probe;
  ImagingSettings settings;
  std::string engine;
  std::vector<PointSpreadRow> rows;
};

/// Images of points at 5 to 45 mm from a linear probe in homogeneous tissue without loss, beside the array's field
/// (bench/pointspread/ArrayField.h). A minute. Fails on a probe that is not linear and on an unknown engine.
Result<PointSpreadBench> runPointSpreadBench(const Probe& probe, std::string_view engine,
                                             const Progress& progress = {});

/// pointspread.csv, index.md and plots by depth. All of it or nothing.
Result<void> writePointSpreadBench(const PointSpreadBench& bench, const std::filesystem::path& folder);
nlohmann::json toJson(const PointSpreadBench& bench);

}  // namespace insonate
