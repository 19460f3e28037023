#pragma once

#include <QString>

namespace insonate::train {

/// Rate of live images on the screen while the probe moves.
struct LiveRates {
  int images = 0;
  double seconds = 0;
  double imagesPerSecond = 0;
  double median_ms = 0, p95_ms = 0;  ///< from sending a pose to drawing its image
  double cpu_ms = 0;                 ///< processor time of the whole program per image
  double window_ms = 0;              ///< share of cpu_ms that the window's thread used
};

/// Timing of the haptic servo with a needle in one hand, while live images are shown and 3D follows.
struct HandRates {
  double imagesPerSecond = 0;
  double ticks = 0, late = 0;  ///< number of servo ticks; number of ticks that began more than a period late
  double p50_us = 0, p99_us = 0, p999_us = 0, max_us = 0;  ///< duration of a tick's work
};

/// Frame rate of the 3D view while it turns.
struct OrbitRates {
  double framesPerSecond = 0, median_ms = 0, p95_ms = 0;
  QString graphics;  ///< graphics driver and device, as OpenGL names them
};

/// Frame rates of 3D with the volume-rendered CT, and the load on the window's thread.
struct VolumeRates {
  /// Frames per second while the view orbits, while it zooms, and while the probe moves.
  double orbitPerSecond = 0, zoomPerSecond = 0, followPerSecond = 0;
  double exact_ms = 0;  ///< from the end of a movement to the image at full resolution; 600 ms at least
  /// Durations for which the window's thread did not process events. `median_ms` and `least_ms` are over the intervals
  /// in which a frame was drawn, `longest_ms` over all intervals; `processor_ms` is the longest in the thread's own
  /// processor time. On a shared machine only `least_ms` and `processor_ms` are caused by this program alone.
  struct Holds {
    double median_ms = 0, least_ms = 0, longest_ms = 0, processor_ms = 0;
  };
  Holds moving, rest;
};

}  // namespace insonate::train
