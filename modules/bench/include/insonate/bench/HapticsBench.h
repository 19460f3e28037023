#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/haptics/HapticMeasurements.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// Timing of the haptic force loop in real time, while simulated hands press the probe and puncture with the needle.
struct HapticsBenchRow {
  /// load during the measurement: `idle`, or `rendering` (the cpu engine makes images without pause)
  std::string scenario;
  std::uint64_t ticks = 0, lateTicks = 0;
  /// percentiles and maximum of the computing time of a tick (1 ms)
  double p50_us = 0, p99_us = 0, p999_us = 0, max_us = 0;
  /// 99th percentile and maximum of the delay from a tick's due time to its beginning
  double wakeP99_us = 0, wakeMax_us = 0;
  int pictures = 0;  ///< number of ultrasound images that were rendered during the measurement
  /// minimum over time of the net energy that a hand has put into the force loop since a contact began; below 0: not
  /// passive
  double passivityMin_J = 0;
};

/// Maximum stable stiffness of a virtual wall, N/mm, for one haptic device held by a hand.
struct StiffnessRow {
  std::string device;
  double maker = 0;  ///< maximum stiffness according to the manufacturer
  double bound = 0;  ///< stiffness up to which device and wall are passive (passiveStiffness_Npmm() at 100 mm/s)
  /// stiffness up to which the device was stable in a simulated hand (maxStableStiffness_Npmm()); at most 20
  double found = 0;
  /// the same as `found`, with passivity control: the force loop returns no more energy than it has received
  double foundAccount = 0;
};

struct ForceDepthCurve {
  std::string table;
  std::vector<ForceDepthPoint> points;
};

struct HapticsBench {
  std::vector<HapticsBenchRow> rows;
  std::vector<StiffnessRow> stiffness;
  /// result for a device of 0.2 kg and 0.2 N s/m that no hand holds, without friction, for comparison with the bound of
  /// Colgate and Schenkel
  StiffnessRow colgate;
  std::vector<ForceDepthCurve> curves;
  std::vector<std::string> notes;
};

/// Runs the haptics benchmark. It takes a minute of real time and some further computing time; if `quick`, seconds.
/// Fails if cancelled.
Result<HapticsBench> runHapticsBench(bool quick, const Progress& progress = {});

nlohmann::json toJson(const HapticsBench& bench);

/// Writes the results into `folder`: haptics.json, haptics.csv, stiffness.csv, force-depth.csv, force-depth.svg and
/// haptics.md; either all of them or none.
Result<void> writeHapticsBench(const HapticsBench& bench, const std::filesystem::path& folder);

}  // namespace insonate
