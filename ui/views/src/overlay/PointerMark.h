#pragma once

#include "Lines.h"

namespace insonate::views {

/// A small cross, open at the middle, where another view is pointed at. It does not hide what it marks.
void drawPointerMark(DisplayPoint at, double scale, Lines& lines);

}  // namespace insonate::views
