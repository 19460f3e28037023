#pragma once

#include "Lines.h"

namespace insonate::views {

/// Draws a small cross, open at the middle, at the point under the pointer of another view. It does not hide the
/// point.
void drawPointerMark(DisplayPoint at, double scale, Lines& lines);

}  // namespace insonate::views
