#pragma once

#include <insonate/bench/UltrasoundBench.h>
#include <insonate/simulator/Imager.h>

#include <functional>
#include <optional>
#include <span>

namespace insonate::bench {

/// Number of frames of a time measurement: at least `least`, then more until `seconds` or `most` is reached.
struct Patience {
  int warmUp = 2, least = 5, most = 60;
  double seconds = 0.5;
};

/// Calls `frame` repeatedly, with the number of the call, and measures the times.
FrameTimes timeFrames(const Patience& patience, const std::function<void(int frame)>& frame);

/// Tissue displacement and needle in the image plane, in the probe's frame, so that they move with the probe.
struct PlaneContents {
  PlaneDisplacement displacement;
  std::optional<Needle> needle;

  void render(Imager& imager, const AcousticScene& scene, const Transform& patientFromProbe, ImagingFrame& frame) const;
};

/// Times of whole frames (engine and display), and of each stage.
struct TimedFrames {
  FrameTimes times;
  std::vector<StageTime> stages;
};
/// Measures whole frames (engine and display) of a probe that moves along `path` and back, with `threads` threads. For
/// each stage, median and minimum time are computed.
TimedFrames timeImager(Imager& imager, const AcousticScene& scene, std::span<const Transform> path,
                       const PlaneContents& contents, int threads, const Patience& patience);

}  // namespace insonate::bench
