#pragma once

#include "MetricsByHand.h"
#include "support/AttemptBlock.h"
#include "support/TestData.h"

#include <insonate/simulator/ScriptedSession.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace insonate::test {

// Whole attempts on the block, and each of their 26 metrics worked out by hand from the block's walls. All times are
// those of hands at 10 mm/s, so that a millimeter is a tenth of a second.

inline const double kSkin_mm = bend_mm(kSkin);       // (0.24 - 0.1) / 0.16 = 0.875; + (1.8 - 0.149) / 0.24 = 7.755
inline const double kVein_mm = 12 + bend_mm(kVein);  // 1.6 + (0.6 - 0.256) / 0.24 = 3.033, below 12 mm
inline const double kBack_mm = 0.3;                  // pulled back as far behind its hole, the tip is out of it
inline const double kRoot2 = std::numbers::sqrt2;

// Why values may be off.
inline constexpr double kTicks_s = 0.004;  // events come with ticks of 1 ms, at a way of 0.01 mm
inline constexpr double kWay_mm = 0.05;    // the same, as a way
inline constexpr double kTurn_mm = 1;      // ways are in steps of 0.5 mm: a turn loses one on either side
inline constexpr double kMiddle_mm = 0.3;  // of a center line found in voxels
inline constexpr double kWall_mm = 0.05;   // distances to flat walls are kept to 0.01 mm
inline constexpr double kEdge_mm = 0.3;    // the map rounds edges over a voxel
inline constexpr double kAngle_deg = 0.5;  // a normal is a difference of distances that are kept to 0.01 mm
inline double share(double way_mm) {       // a step of the way forward
  return 100 * 0.5 / way_mm;
}

class BlockAttempt : public testing::Test {
 protected:
  SessionOutcome play(const std::string& actions, const std::string& more = "") {
    const auto script = readSessionScript("{" + more + "\"acts\": [" + actions + "]}", patient);
    EXPECT_TRUE(script) << script.error().message;
    auto outcome = runSession(*script, patient, "insonate test", folder / "attempt", {});
    if (!outcome) throw std::runtime_error(outcome.error().message);
    return std::move(*outcome);
  }
  /// Square to the skin at (x, z), the tip 5 mm before it.
  static std::string needle(int x_mm, int z_mm = 0) {
    const std::string x = std::to_string(x_mm), z = std::to_string(z_mm);
    return "{\"needle\": {\"from_mm\": [" + x + ", -5.5, " + z + "], \"to\": [" + x + ", 17.5, " + z + "]}}";
  }

  const PatientCase patient = attemptBlock();
  const TemporaryFolder folder;
};

}  // namespace insonate::test
