#include "NeedleMotion.h"

#include "LiveModel.h"

namespace insonate::train {

void NeedleMotion::take(NeedlePlane plane) {
  if (live_.checkLive()) hands_.takeNeedle(plane);
}

void NeedleMotion::toggle() {
  if (hands_.needleHand())
    hands_.removeNeedle();
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
