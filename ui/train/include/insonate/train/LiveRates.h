#pragma once

#include <QString>

namespace insonate::train {

/// Rate of live images on the screen under a moving probe.
struct LiveRates {
  int images = 0;
  double seconds = 0;
  double imagesPerSecond = 0;
  double median_ms = 0, p95_ms = 0;  ///< from a pose in the hand to its image drawn
  double cpu_ms = 0;                 ///< processor time of the whole program for each image
  double window_ms = 0;              ///< of that, the window's own thread
};

/// The servo of the hands, with a needle in one, while live images are shown and 3D follows.
struct HandRates {
  double imagesPerSecond = 0;
  double ticks = 0, late = 0;                              ///< of its ticks, those that began a period late
  double p50_us = 0, p99_us = 0, p999_us = 0, max_us = 0;  ///< of the work of a tick
};

/// Rate at which the patient in 3D turns.
struct OrbitRates {
  double framesPerSecond = 0, median_ms = 0, p95_ms = 0;
  QString graphics;  ///< what draws it, in OpenGL's words
};

/// Rate of 3D with the cast CT in it, and its cost to the window's own thread.
struct VolumeRates {
  double orbitPerSecond = 0, zoomPerSecond = 0, followPerSecond = 0;  ///< images; the last while the probe moves
  double exact_ms = 0;  ///< from the last of a movement to the image that lacks nothing; 600 ms at least
  /// Longest time without events on the thread: usually with an image, at best, and at worst. On a shared machine the
  /// program is responsible for the best one, and for the longest in the thread's own processor time.
  struct Holds {
    double median_ms = 0, least_ms = 0, longest_ms = 0, processor_ms = 0;
  };
  Holds moving, rest;
};

}  // namespace insonate::train
