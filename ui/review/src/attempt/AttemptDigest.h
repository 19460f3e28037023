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

/// Positions of both hands at one time of the attempt, for lanes and paths.
struct TrackPoint {
  std::int64_t time_us = 0;
  std::optional<double> needleDepth_mm;  ///< empty while the needle is outside
  std::optional<Vec3> tip_mm;            ///< patient's frame (LPS)
  /// Position of the tip in the probe's frame at that time: lateral, elevation, depth. Empty unless both hands are
  /// present.
  std::optional<Vec3> tip_probe;
  double probeForce_N = 0;
  NeedlePlace place = NeedlePlace::Clean;
  bool probeOnSkin = false, aspirating = false;
};

/// Data of a recording that was read once from beginning to end. Constant; for any thread.
struct AttemptDigest {
  std::string file;
  std::shared_ptr<const AttemptRecording> recording;
  std::int64_t end_us = 0;
  std::vector<TrackPoint> track;  ///< in order of time, about kTrack_Hz points per second
  struct PlaceChange {
    std::int64_t time_us = 0;
    NeedlePlace place = NeedlePlace::Clean;
    std::string vessel{};  ///< result of ProcedureRun::vesselIn()
  };
  std::vector<PlaceChange> places;     ///< changes of the needle's place, each with its time
  std::vector<AttemptMoment> moments;  ///< in order of time
  /// Score; empty if parts of the recording are missing, since numbers would be wrong.
  std::optional<AttemptScore> score;
  std::vector<std::string> troubles;

  PlaceChange placeAt(std::int64_t time_us) const;
};
inline constexpr int kTrack_Hz = 50;

/// Reads a recording. Fails if the file is no recording, was written by a newer program, or when cancelled. For any
/// thread; takes about a second for ten minutes of recording.
Result<std::shared_ptr<const AttemptDigest>> digestOf(const std::string& file, const Progress& progress = {});

}  // namespace insonate::review
