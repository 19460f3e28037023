#pragma once

#include <insonate/procedure/AttemptMetrics.h>
#include <insonate/procedure/AttemptSample.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace insonate {

/// Positions of probe and needle at one time of an attempt, for timelines and for paths.
struct TrackPoint {
  std::int64_t time_us = 0;
  std::optional<double> needleDepth_mm{};  ///< depth of the needle; empty while the needle is outside
  std::optional<Vec3> tip_mm{};            ///< position of the needle's tip in patient space (LPS)
  /// Position of the tip in the probe frame at that time: lateral, elevation, depth. Empty unless both probe and
  /// needle are held.
  std::optional<Vec3> tip_probe{};
  double probeForce_N = 0;
  NeedlePlace place = NeedlePlace::Clean;
  bool probeOnSkin = false, aspirating = false;
};

inline constexpr int kTrack_Hz = 50;

/// Adds the point of a sample to a track, unless the last point of the track is less than 1 / kTrack_Hz before the
/// sample. `place`: place of the needle after the sample (AttemptMetrics::needle()).
void addToTrack(std::vector<TrackPoint>& track, const AttemptSample& sample, NeedlePlace place);

}  // namespace insonate
