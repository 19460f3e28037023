#pragma once

#include <insonate/simulator/LiveImaging.h>
#include <insonate/tissue/Labels.h>

#include <QColor>

namespace insonate::train {

/// Area of a vessel; null if there is none in the plane.
const LumenArea* lumenOf(const LivePress& press, Label label);

/// Tells whether the probe's pressure is high enough for a number.
bool presses(const LivePress& press);

/// Color of the vessel in text and curves over the image.
QColor vesselColour(Label label);

}  // namespace insonate::train
