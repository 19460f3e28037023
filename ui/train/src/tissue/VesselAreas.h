#pragma once

#include <insonate/simulator/LiveImaging.h>
#include <insonate/tissue/Labels.h>

#include <QColor>

namespace insonate::train {

/// Null where no such vessel is known in the plane.
const LumenArea* lumenOf(const LivePress& press, Label label);

/// Tells whether the probe's pressure is high enough for a number.
bool presses(const LivePress& press);

/// As the vessel is told in words and curves over the picture.
QColor vesselColour(Label label);

}  // namespace insonate::train
