#pragma once

#include <QColor>

namespace insonate::review {

/// Returns heatColorOf() (HeatMap.h of teaching) for painting.
QColor heatColor(double share);
/// Returns black or white, whichever is more legible on this background.
QColor inkOn(const QColor& ground);

}  // namespace insonate::review
