#pragma once

#include <QString>

namespace insonate::train {

/// How fast live pictures came onto the screen under a moving probe.
struct LiveRates {
  int images = 0;
  double seconds = 0;
  double imagesPerSecond = 0;
  double median_ms = 0, p95_ms = 0;  ///< from a pose in the hand to its picture drawn
  double cpu_ms = 0;                 ///< processor time of the whole program for each picture
  double window_ms = 0;              ///< of that, the window's own thread
};

/// How fast the patient in 3D turns.
struct OrbitRates {
  double framesPerSecond = 0, median_ms = 0, p95_ms = 0;
  QString graphics;  ///< what draws it, in OpenGL's words
};

}  // namespace insonate::train
