#pragma once

#include <vector>

namespace insonate::views {

class SceneView;

/// Durations in milliseconds of a scene's frames.
struct FrameTimes {
  std::vector<double> moving_ms;  ///< each frame while the camera turned, in order
  double still_ms = 0;            ///< the first frame at full resolution after the camera stopped

  double median_ms() const;
  /// 95th percentile of moving_ms.
  double percentile95_ms() const;
  /// Frames per second while moving, from the median of moving_ms.
  double perSecond() const;
};

/// Turns the camera as a drag does, in `steps` steps of `step_deg`, and waits for the frame of each step. Then turns
/// the camera back and draws a frame at full resolution. The view must be in a window. No measurement for steps below
/// 1.
FrameTimes timeOrbit(SceneView& view, int steps, double step_deg = 3);

}  // namespace insonate::views
