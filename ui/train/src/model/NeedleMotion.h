#pragma once

#include "HandsControl.h"

namespace insonate::train {

class LiveModel;

/// Moves of the needle by mouse, keys and numbers. They are refused while the image is frozen.
class NeedleMotion {
 public:
  NeedleMotion(HandsControl& hands, LiveModel& live) : hands_(hands), live_(live) {}

  void take(NeedlePlane plane);
  /// Takes up the needle as it was held last, or puts it away.
  void toggle();
  void move(NeedleAxis axis, double mmOrDegrees);
  /// Moves to a typed number: Heading, Angle, Bevel, Advance.
  void set(NeedleAxis axis, double mmOrDegrees);

 private:
  HandsControl& hands_;
  LiveModel& live_;
};

}  // namespace insonate::train
