#pragma once

#include <insonate/simulator/LiveImaging.h>
#include <insonate/tissue/Labels.h>

#include <QColor>

namespace insonate::train {

/// Returns the area of a vessel; null if the vessel is not in the plane.
const LumenArea* lumenOf(const LiveDeformation& press, Label label);

/// Tells whether the probe's force is large enough to be displayed as a number.
bool presses(const LiveDeformation& press);

/// Returns the color of a vessel in text and curves over the image.
QColor vesselColor(Label label);

}  // namespace insonate::train
