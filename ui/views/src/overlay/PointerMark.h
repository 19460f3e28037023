#pragma once

#include "Lines.h"

namespace insonate::views {

/// Draws a small cross with an open center at the point under the pointer of another view. The open center leaves the
/// point visible.
void drawPointerMark(DisplayPoint at, double scale, Lines& lines);

}  // namespace insonate::views
