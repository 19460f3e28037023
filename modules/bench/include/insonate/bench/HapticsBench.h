#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/haptics/HapticEvidence.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// The servo's thread with two simulated hands that press and prick, in real time.
struct HapticsBenchRow {
  std::string scenario;  ///< `idle`, or `rendering`: while the cpu engine makes images without a pause
  std::uint64_t ticks = 0, lateTicks = 0;
  double p50_us = 0, p99_us = 0, p999_us = 0, max_us = 0;  ///< of the work of a tick
  double wakeP99_us = 0, wakeMax_us = 0;                   ///< from when a tick should begin to when it does
  int pictures = 0;                                        ///< made meanwhile
  double passivityMin_J = 0;  ///< least energy that a hand had put in at any moment of a contact
};

/// Maximum stable stiffness of a wall, N/mm, for one device in a hand.
struct StiffnessRow {
  std::string device;
  double maker = 0;         ///< greatest that is shown on it
  double bound = 0;         ///< up to which device and wall are passive by themselves, at 100 mm/s
  double found = 0;         ///< up to which it was stable in a simulated hand (at most 20)
  double foundAccount = 0;  ///< the same with the servo's account of energy
};

struct ForceDepthCurve {
  std::string table;
  std::vector<ForceDepthPoint> points;
};

struct HapticsBench {
  std::vector<HapticsBenchRow> rows;
  std::vector<StiffnessRow> stiffness;
  StiffnessRow colgate;  ///< a free device of 0.2 kg with 0.2 N s/m and nothing else
  std::vector<ForceDepthCurve> curves;
  std::vector<std::string> notes;
};

/// A minute of real time and some of work; quick: seconds. Fails when cancelled.
Result<HapticsBench> runHapticsBench(bool quick, const Progress& progress = {});

nlohmann::json toJson(const HapticsBench& bench);

/// haptics.json, haptics.csv, stiffness.csv, force-depth.csv, force-depth.svg and haptics.md; all of them or none.
Result<void> writeHapticsBench(const HapticsBench& bench, const std::filesystem::path& folder);

}  // namespace insonate
