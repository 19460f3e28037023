#pragma once

#include <insonate/bench/UltrasoundBench.h>
#include <insonate/simulator/Imager.h>

#include <functional>
#include <optional>
#include <span>

namespace insonate::bench {

/// Duration of a row: at least `least` frames, then more until `seconds` or `most` are reached.
struct Patience {
  int warmUp = 2, least = 5, most = 60;
  double seconds = 0.5;
};

/// Milliseconds of repeated calls; `frame` gets the number of the call.
FrameTimes timeFrames(const Patience& patience, const std::function<void(int frame)>& frame);

/// Contents of the plane besides the scene, in the probe's frame, so that they move with it.
struct PlaneContents {
  PlaneDisplacement displacement;
  std::optional<Needle> needle;

  void render(Imager& imager, const AcousticScene& scene, const Transform& patientFromProbe, ImagingFrame& frame) const;
};

/// Whole frames, engine and display, of a probe that moves along `path` and back, on an arena of `threads`. Stages get
/// the median and the least of their times.
struct TimedFrames {
  FrameTimes times;
  std::vector<StageTime> stages;
};
TimedFrames timeImager(Imager& imager, const AcousticScene& scene, std::span<const Transform> path,
                       const PlaneContents& contents, int threads, const Patience& patience);

}  // namespace insonate::bench
