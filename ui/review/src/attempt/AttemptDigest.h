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

/// Positions of probe and needle at one time of the attempt, for the timeline's lanes and for paths.
struct TrackPoint {
  std::int64_t time_us = 0;
  std::optional<double> needleDepth_mm;  ///< depth of the needle; empty while the needle is outside
  std::optional<Vec3> tip_mm;            ///< position of the needle's tip in the patient's frame (LPS)
  /// Position of the tip in the probe's frame at that time: lateral, elevation, depth. Empty unless both probe and
  /// needle are held.
  std::optional<Vec3> tip_probe;
  double probeForce_N = 0;
  NeedlePlace place = NeedlePlace::Clean;
  bool probeOnSkin = false, aspirating = false;
};

/// Data of a recording that was read once from beginning to end. The data are constant; any thread may read them.
struct AttemptDigest {
  std::string file;
  std::shared_ptr<const AttemptRecording> recording;
  std::int64_t end_us = 0;
  std::vector<TrackPoint> track;  ///< positions in the order of their times, about kTrack_Hz per second
  struct PlaceChange {
    std::int64_t time_us = 0;
    NeedlePlace place = NeedlePlace::Clean;
    std::string vessel{};  ///< result of ProcedureRun::vesselAtTip()
  };
  std::vector<PlaceChange> places;     ///< changes of the needle's place, each with its time
  std::vector<AttemptMoment> moments;  ///< moments in the order of their times
  /// Score; empty if parts of the recording are missing, since numbers would be wrong.
  std::optional<AttemptScore> score;
  std::vector<std::string> errors;

  PlaceChange placeAt(std::int64_t time_us) const;
};
inline constexpr int kTrack_Hz = 50;

/// Reads a recording. Fails if the file is no recording or was written by a newer version of the program, and when
/// cancelled. May be called on any thread; takes about a second for a recording of ten minutes.
Result<std::shared_ptr<const AttemptDigest>> digestOf(const std::string& file, const Progress& progress = {});

}  // namespace insonate::review
