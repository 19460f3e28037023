#pragma once

#include "attempt/Canvas.h"
#include "attempt/ReplayCursor.h"

#include <insonate/procedure/AttemptScore.h>
#include <insonate/simulator/LiveImaging.h>

#include <cstdint>
#include <vector>

namespace insonate::video {

/// State of an attempt at the time of one frame.
struct VideoMoment {
  std::int64_t time_us = 0, end_us = 0;
  const LiveFrame* image = nullptr;  ///< null: no probe is held
  const ReplayCursor& replay;
  const std::vector<AttemptMoment>& moments;  ///< of the whole attempt
};

/// Draws a frame of the video of an attempt.
void drawMoment(const VideoMoment& moment, Canvas& canvas);

}  // namespace insonate::video
