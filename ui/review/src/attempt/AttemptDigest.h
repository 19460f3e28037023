#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/procedure/AttemptScore.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace insonate::review {

/// Both hands at a time of the attempt, for lanes and paths.
struct TrackPoint {
  std::int64_t time_us = 0;
  std::optional<double> needleDepth_mm;  ///< none: outside
  std::optional<Vec3> tip_mm;            ///< patient LPS
  /// The tip in the probe's frame at that time: lateral, across the slice, deep. None without both hands.
  std::optional<Vec3> tip_probe;
  double probeForce_N = 0;
  NeedlePlace place = NeedlePlace::Clean;
  bool probeOnSkin = false, aspirating = false;
};

/// A recording read once from beginning to end. Constant; any thread.
struct AttemptDigest {
  std::string file;
  std::shared_ptr<const AttemptRecording> recording;
  std::int64_t end_us = 0;
  std::vector<TrackPoint> track;  ///< about kTrack_Hz of them a second, in order
  struct PlaceChange {
    std::int64_t time_us = 0;
    NeedlePlace place = NeedlePlace::Clean;
    std::string vessel{};  ///< ProcedureRun::vesselIn()
  };
  std::vector<PlaceChange> places;     ///< the needle's place from each time on
  std::vector<AttemptMoment> moments;  ///< in order
  /// Score; empty if parts are missing, since numbers would be wrong.
  std::optional<AttemptScore> score;
  std::vector<std::string> troubles;

  PlaceChange placeAt(std::int64_t time_us) const;
};
inline constexpr int kTrack_Hz = 50;

/// Fails where the file is no recording or of a newer program, and when cancelled. Any thread; about a second for ten
/// minutes.
Result<std::shared_ptr<const AttemptDigest>> digestOf(const std::string& file, const Progress& progress = {});

}  // namespace insonate::review
