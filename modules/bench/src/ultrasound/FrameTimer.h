#pragma once

#include <insonate/bench/UltrasoundBench.h>
#include <insonate/simulator/Imager.h>

#include <functional>
#include <optional>
#include <span>

namespace insonate::bench {

/// Number of frames of a row: at least `least`, then more until `seconds` or `most` is reached.
struct Patience {
  int warmUp = 2, least = 5, most = 60;
  double seconds = 0.5;
};

/// Measures repeated calls in milliseconds; `frame` receives the number of the call.
FrameTimes timeFrames(const Patience& patience, const std::function<void(int frame)>& frame);

/// Objects in the plane in addition to the scene, in the probe's frame, so that they move with the probe.
struct PlaneContents {
  PlaneDisplacement displacement;
  std::optional<Needle> needle;

  void render(Imager& imager, const AcousticScene& scene, const Transform& patientFromProbe, ImagingFrame& frame) const;
};

/// Measures whole frames, engine and display, of a probe that moves along `path` and back, in an arena of `threads`.
/// For each stage, median and minimum time are computed.
struct TimedFrames {
  FrameTimes times;
  std::vector<StageTime> stages;
};
TimedFrames timeImager(Imager& imager, const AcousticScene& scene, std::span<const Transform> path,
                       const PlaneContents& contents, int threads, const Patience& patience);

}  // namespace insonate::bench
