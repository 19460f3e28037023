#pragma once

#include <QString>

namespace insonate::train {

/// Frame rate of the live image on the screen while the probe moves.
struct LiveRates {
  int images = 0;
  double seconds = 0;
  double imagesPerSecond = 0;
  double median_ms = 0, p95_ms = 0;  ///< time from setting a pose until its image is drawn: median, 95th percentile
  double cpu_ms = 0;                 ///< processor time of the whole program per image
  double window_ms = 0;              ///< part of cpu_ms that the window's thread used
};

/// Times from jumps of the probe to the image of its new position on the screen.
struct JumpRates {
  int jumps = 0;
  struct Times {
    double median_ms = 0, p95_ms = 0, longest_ms = 0;
  };
  Times firstImage;   ///< until the first image of the new position
  Times fullQuality;  ///< until the first image of the new position that is not coarse (LiveFrame::isCoarse)
  /// Mean absolute difference between the first coarse image and the first image of full quality, gray levels of 255:
  /// median and 95th percentile of the jumps with a coarse image. It includes noise and pulsation between the two.
  double differenceMedian = 0, differenceP95 = 0;
};

/// Timing of the force loop with a haptic device that moves the needle, while live images are shown and the 3D view
/// follows the probe.
struct HandRates {
  double imagesPerSecond = 0;
  /// number of ticks of the force loop; number of ticks that began more than a period late
  double ticks = 0, late = 0;
  double p50_us = 0, p99_us = 0, p999_us = 0, max_us = 0;  ///< percentiles and maximum of the computing time of a tick
};

/// Frame rate of the 3D view while it turns.
struct OrbitRates {
  double framesPerSecond = 0, median_ms = 0, p95_ms = 0;
  QString graphics;  ///< graphics driver and device, as OpenGL names them
};

/// Frame rates of the 3D view with the volume-rendered CT, and stalls of the window's thread.
struct VolumeRates {
  /// Frames per second while the view orbits, while it zooms, and while the probe moves.
  double orbitPerSecond = 0, zoomPerSecond = 0, followPerSecond = 0;
  double exact_ms = 0;  ///< time from the end of a movement until the image has its full resolution; at least 600
  /// GUI stalls: durations for which the window's thread did not process events. `median_ms` and `min_ms` (minimum)
  /// are computed from the intervals in which a frame was drawn, `longest_ms` from all intervals. `processor_ms` is the
  /// maximum of the processor time that the thread used in one interval. On a computer with other programs running,
  /// only `min_ms` and `processor_ms` depend on this program alone.
  struct Holds {
    double median_ms = 0, min_ms = 0, longest_ms = 0, processor_ms = 0;
  };
  Holds moving, rest;
};

}  // namespace insonate::train
