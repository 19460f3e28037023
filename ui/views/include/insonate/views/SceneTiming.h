#pragma once

#include <vector>

namespace insonate::views {

class SceneView;

/// Durations of a scene's frames, in milliseconds.
struct FrameTimes {
  std::vector<double> moving_ms;  ///< each image while the camera turned, in order
  double still_ms = 0;            ///< the exact image after it

  double median_ms() const;
  /// The slowest one in twenty is slower than this.
  double percentile95_ms() const;
  /// Images a second while moving: by the median.
  double perSecond() const;
};

/// Turns the camera as dragging does, in `steps` steps of `step_deg`, draws an image for each and waits until it is
/// there. Then turns it back and draws the image of rest. The view must be in a window. Nothing for steps below 1.
FrameTimes timeOrbit(SceneView& view, int steps, double step_deg = 3);

}  // namespace insonate::views
