#include "NeedleMotion.h"

#include "LiveModel.h"

namespace insonate::train {

/// A needle leaves the body only along its path, as a real one does.
bool NeedleMotion::checkOutside() {
  if (!hands_.needle() || !hands_.needle()->state.inBody) return true;
  Q_EMIT hands_.messageReported(
      HapticControl::tr("The needle is in the body. Withdraw it from the skin first (Page Up; with Shift by 5 mm)."));
  return false;
}

void NeedleMotion::take(NeedlePlane plane) {
  if (live_.checkLive() && checkOutside()) hands_.takeNeedle(plane);
}

void NeedleMotion::putAway() {
  if (checkOutside()) hands_.removeNeedle();
}

void NeedleMotion::toggle() {
  if (hands_.needleHand())
    putAway();
  else
    take(hands_.needlePlane());
}

void NeedleMotion::move(NeedleAxis axis, double mmOrDegrees) {
  if (live_.checkLive()) hands_.moveNeedle(axis, mmOrDegrees);
}

void NeedleMotion::set(NeedleAxis axis, double mmOrDegrees) {
  if (live_.checkLive()) hands_.setNeedle(axis, mmOrDegrees);
}

}  // namespace insonate::train
