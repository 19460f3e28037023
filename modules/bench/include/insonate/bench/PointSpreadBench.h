#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/ultrasound/ImagingSettings.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// Properties of a beam at one depth, measured in the amplitude image of a point. Contrasts and correlation lengths
/// apply to fully developed speckle with this point-spread function. The members from cnr4 on are measured in images of
/// speckle with anechoic cysts, without noise.
struct PointSpreadFigures {
  double lateral_mm = 0, lateral20dB_mm = 0;  ///< lateral full widths: at half maximum; at -20 dB, side lobes included
  double axial_mm = 0, slice_mm = 0;          ///< axial full width and slice thickness, at half maximum
  double endLateral_mm = 0;                   ///< lateral_mm at a distance of 1.2 mm from the array's end
  double aside_dB = 0;     ///< maximum level of the point's image at lateral distances of 2 mm and more
  double sideLobe_dB = 0;  ///< maximum level beyond the first minimum beside the main lobe; -120 if there is none
  /// Level in the middle of a lumen of 4 or 8 mm diameter, relative to its surroundings.
  double lumen4_dB = 0, lumen8_dB = 0;
  /// Full widths at half maximum of the speckle intensity's autocorrelation.
  double speckleLateral_mm = 0, speckleAxial_mm = 0;
  double cnr4 = 0, cnr8 = 0;    ///< contrast-to-noise ratio of a cyst of 4 or 8 mm, from amplitudes; at most 1.91
  double gcnr4 = 0, gcnr8 = 0;  ///< generalized contrast-to-noise ratio, 0 to 1
  /// mean amplitude of speckle divided by its standard deviation; 1.91 for fully developed speckle
  double speckleSnr = 0;
};

struct PointSpreadRow {
  double depth_mm = 0;
  /// `ours`: properties of the engine's images; `field`: properties of the independently computed field of the array
  PointSpreadFigures ours, field;
};

struct PointSpreadBench {
  Probe probe;
  ImagingSettings settings;
  std::string engine;
  std::vector<PointSpreadRow> rows;
};

/// Makes images of points at 5 to 45 mm from a linear probe in homogeneous tissue without loss, and computes the
/// array's field for comparison (bench/pointspread/ArrayField.h). Takes a minute or two. Fails if the probe is not
/// linear or the engine is unknown.
Result<PointSpreadBench> runPointSpreadBench(const Probe& probe, std::string_view engine,
                                             const Progress& progress = {});

/// Writes the results into `folder`: pointspread.csv, index.md and plots by depth; either all of them or none.
Result<void> writePointSpreadBench(const PointSpreadBench& bench, const std::filesystem::path& folder);
nlohmann::json toJson(const PointSpreadBench& bench);

}  // namespace insonate
