#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// Errors of one method of measuring poses.
struct HandsBenchErrors {
  double tip_mm = 0, tipP95_mm = 0;  ///< distance of the needle's tip from the truth: root mean square, 95th percentile
  double direction_deg = 0;          ///< root mean square angle of the needle
  double probe_mm = 0;               ///< root mean square distance of the center of the probe's face
  double seen = 0;                   ///< share of the frames in which the needle was measured, 0 to 1
};

/// A condition of camera, light and motion. Errors are those of the filtered poses, in the camera frame, at the middle
/// of the exposure, from half a second after the start.
struct HandsBenchRow {
  std::string condition;
  int width = 0, height = 0;
  int frames = 0;
  double speed_mmps = 0;  ///< root mean square speed of the needle's tip
  HandsBenchErrors corners, intensities;
  double jitter_mm = 0;   ///< at rest: root mean square distance of the needle's tip from its mean; else 0
  double cost_ms = 0;     ///< processor time of a frame with both bodies, median
  double core = 0;        ///< share of a core at 30 fps, 0 to 1
  double lag_ms = 0;      ///< delay of the filter: the shift in time with the smallest error; 0 at rest
  double latency_ms = 0;  ///< half the exposure, one frame interval for readout and transfer, computing, and lag
};

struct HandsBench {
  std::vector<HandsBenchRow> rows;
  std::vector<std::string> notes;
};

/// Measures the tracking of hand-held bodies in rendered images of known motions; takes some minutes, and about 20 s if
/// `quick`. Fails if cancelled.
Result<HandsBench> runHandsBench(bool quick, const Progress& progress = {});

nlohmann::json toJson(const HandsBench& bench);

/// Writes hands.json, hands.csv and hands.md into `folder`; either all of them or none.
Result<void> writeHandsBench(const HandsBench& bench, const std::filesystem::path& folder);

}  // namespace insonate
