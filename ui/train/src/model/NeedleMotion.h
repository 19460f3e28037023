#pragma once

#include "HandsControl.h"

namespace insonate::train {

class LiveModel;

/// Moves the needle by mouse, keys and numbers. Refused while the image is frozen.
class NeedleMotion {
 public:
  static constexpr double kWheel_mm = 1;  ///< advance of a notch of the wheel

  NeedleMotion(HandsControl& hands, LiveModel& live) : hands_(hands), live_(live) {}

  void take(NeedlePlane plane);
  /// Takes up the needle as it was last held, or puts it away.
  void toggle();
  void move(NeedleAxis axis, double mmOrDegrees);
  /// Moves the needle to a typed number; `axis` is Heading, Angle, Bevel or Advance.
  void set(NeedleAxis axis, double mmOrDegrees);

 private:
  HandsControl& hands_;
  LiveModel& live_;
};

}  // namespace insonate::train
