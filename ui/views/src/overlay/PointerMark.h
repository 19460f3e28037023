#pragma once

#include "Lines.h"

namespace insonate::views {

/// Draws a small cross with an open center at the point that is under the pointer of another view. The open center
/// leaves this point visible.
void drawPointerMark(DisplayPoint at, double scale, Lines& lines);

}  // namespace insonate::views
