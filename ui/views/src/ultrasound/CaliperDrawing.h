#pragma once

#include "../overlay/Lines.h"
#include "../overlay/Texts.h"

#include <insonate/views/Caliper.h>

#include <functional>

namespace insonate::views {

/// Function that maps a point of the caliper's plane to the display.
using ToDisplay = std::function<DisplayPoint(ImagePoint)>;

/// Draws one caliper with its number.
void drawCaliper(const Caliper& caliper, int number, const ToDisplay& toDisplay, double scale, Lines& lines,
                 Texts& texts);

}  // namespace insonate::views
