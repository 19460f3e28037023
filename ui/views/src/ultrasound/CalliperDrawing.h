#pragma once

#include "../overlay/Lines.h"
#include "../overlay/Texts.h"

#include <insonate/views/Calliper.h>

#include <functional>

namespace insonate::views {

/// Mapping of a view that shows the caliper's plane.
using ToDisplay = std::function<DisplayPoint(PicturePoint)>;

/// One caliper with its number.
void drawCalliper(const Calliper& calliper, int number, const ToDisplay& toDisplay, double scale, Lines& lines,
                  Texts& texts);

}  // namespace insonate::views
