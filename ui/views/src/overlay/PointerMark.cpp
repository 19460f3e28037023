#include "PointerMark.h"

namespace insonate::views {

void drawPointerMark(DisplayPoint at, double scale, Lines& lines) {
  constexpr double kGap = 4, kArm = 13;
  for (const DisplayPoint way : {DisplayPoint{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
    const DisplayPoint from{at.x + way.x * kGap * scale, at.y + way.y * kGap * scale};
    const DisplayPoint to{at.x + way.x * kArm * scale, at.y + way.y * kArm * scale};
    lines.segment(from, to, {theme::kBlack, 3.5 * scale, 0.6});
    lines.segment(from, to, {theme::kAccent, 1.5 * scale, 1});
  }
}

}  // namespace insonate::views
