#pragma once

#include "HapticControl.h"

namespace insonate::train {

class LiveModel;

/// Moves the needle by mouse, keys and numbers. Moves are refused while the image is frozen. A needle in the body can
/// be neither taken anew nor put away; it must be withdrawn from the skin first.
class NeedleMotion {
 public:
  static constexpr double kWheel_mm = 1;  ///< distance of advance for one notch of the wheel

  NeedleMotion(HapticControl& hands, LiveModel& live) : hands_(hands), live_(live) {}

  void take(NeedlePlane plane);
  void putAway();
  /// Takes the needle in the plane in which it was last taken, or puts it away.
  void toggle();
  void move(NeedleAxis axis, double mmOrDegrees);
  /// Moves the needle to a typed number; `axis` is Heading, Angle, Bevel or Advance.
  void set(NeedleAxis axis, double mmOrDegrees);

 private:
  bool checkOutside();

  HapticControl& hands_;
  LiveModel& live_;
};

}  // namespace insonate::train
