#pragma once

#include "../overlay/Lines.h"
#include "../overlay/Texts.h"

#include <insonate/views/UltrasoundView.h>

namespace insonate::views {

/// One calliper with its number and value.
void drawCalliper(const Calliper& calliper, int number, const UltrasoundView& view, double scale, Lines& lines,
                  Texts& texts);

}  // namespace insonate::views
