#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/procedure/AttemptScore.h>
#include <insonate/teaching/AttemptTrack.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace insonate::review {

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

/// Reads a recording. Fails if the file is no recording or was written by a newer version of the program, and when
/// cancelled. May be called on any thread; takes about a second for a recording of ten minutes.
Result<std::shared_ptr<const AttemptDigest>> digestOf(const std::string& file, const Progress& progress = {});

}  // namespace insonate::review
