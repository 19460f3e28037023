#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// Advance of a wire into the veins of a built-in neck: cost of each millimeter, and error against a converged solution
/// (nodes every 0.25 mm, 20 times smaller unbalanced forces).
struct WireBenchRow {
  std::string wire;
  double spacing_mm = 0;
  int angle_deg = 0;                             ///< angle between needle and vein
  double inserted_mm = 0;                        ///< length at the end, or where the wire stopped
  double median_ms = 0, p95_ms = 0, max_ms = 0;  ///< time of an advance of 1 mm
  double meanIterations = 0;                     ///< Newton steps for each millimeter
  /// distance of a node from the converged wire: root mean square over the wire, at all lengths that are a multiple of
  /// 10 mm; and its 95th percentile
  double error_mm = 0, errorP95_mm = 0;
  double tipError_mm = 0;   ///< root mean square distance between the tips
  double forceError_N = 0;  ///< root mean square difference of the resistance
  double maxForce_N = 0;    ///< largest resistance of the converged wire
  double unbalanced_N = 0;  ///< largest force on a node that the solver left
};

struct WireBench {
  std::vector<WireBenchRow> rows;
  std::vector<std::string> notes;
};

/// Runs the benchmark of the wire; takes a minute, and seconds if `quick`. Fails if cancelled.
Result<WireBench> runWireBench(bool quick, const Progress& progress = {});

nlohmann::json toJson(const WireBench& bench);

/// Writes wire.json, wire.csv and wire.md into `folder`; either all of them or none.
Result<void> writeWireBench(const WireBench& bench, const std::filesystem::path& folder);

}  // namespace insonate
