#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/haptics/HapticEvidence.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// Timing of the servo's thread with two simulated hands that press and puncture, in real time.
struct HapticsBenchRow {
  std::string scenario;  ///< `idle`, or `rendering`: the cpu engine makes images without pause
  std::uint64_t ticks = 0, lateTicks = 0;
  double p50_us = 0, p99_us = 0, p999_us = 0, max_us = 0;  ///< working time of a tick
  double wakeP99_us = 0, wakeMax_us = 0;                   ///< delay from a tick's due time to its beginning
  int pictures = 0;                                        ///< number of images made meanwhile
  double passivityMin_J = 0;  ///< minimum, over all moments of a contact, of the energy that a hand had put in
};

/// Maximum stable stiffness of a wall, N/mm, for one device in a hand.
struct StiffnessRow {
  std::string device;
  double maker = 0;         ///< maximum stiffness that the device renders, according to its manufacturer
  double bound = 0;         ///< stiffness up to which device and wall are passive by themselves, at 100 mm/s
  double found = 0;         ///< stiffness up to which the device was stable in a simulated hand (at most 20)
  double foundAccount = 0;  ///< like `found`, with the servo's energy account
};

struct ForceDepthCurve {
  std::string table;
  std::vector<ForceDepthPoint> points;
};

struct HapticsBench {
  std::vector<HapticsBenchRow> rows;
  std::vector<StiffnessRow> stiffness;
  StiffnessRow colgate;  ///< row of a free device of 0.2 kg with 0.2 N s/m and no other mechanics
  std::vector<ForceDepthCurve> curves;
  std::vector<std::string> notes;
};

/// Runs the benchmark, which takes a minute of real time plus some computation; `quick`: seconds. Fails if cancelled.
Result<HapticsBench> runHapticsBench(bool quick, const Progress& progress = {});

nlohmann::json toJson(const HapticsBench& bench);

/// Writes haptics.json, haptics.csv, stiffness.csv, force-depth.csv, force-depth.svg and haptics.md; either all of them
/// or none.
Result<void> writeHapticsBench(const HapticsBench& bench, const std::filesystem::path& folder);

}  // namespace insonate
