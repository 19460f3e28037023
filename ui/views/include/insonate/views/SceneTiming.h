#pragma once

#include <vector>

namespace insonate::views {

class SceneView;

/// Durations in milliseconds of a scene's frames.
struct FrameTimes {
  std::vector<double> moving_ms;  ///< duration of each frame while the camera turned, in their order
  double still_ms = 0;            ///< duration of the first frame at full resolution after the camera has stopped

  double median_ms() const;
  /// Returns the 95th percentile of moving_ms.
  double percentile95_ms() const;
  /// Returns the frames per second during the movement, computed from the median of moving_ms.
  double perSecond() const;
};

/// Turns the camera in `steps` steps of `step_deg`, as a mouse drag does, and measures the frame of each step. Then
/// turns the camera back and draws a frame at full resolution. The view must be in a window. If `steps` is below 1,
/// nothing is measured.
FrameTimes timeOrbit(SceneView& view, int steps, double step_deg = 3);

}  // namespace insonate::views
