#include "CaliperDrawing.h"

#include <cmath>

namespace insonate::views {
namespace {

class Pen {
 public:
  Pen(Lines& lines, double scale) : lines_(lines), scale_(scale) {}

  /// The mark that sonographers use: a cross whose center is the point.
  void cross(DisplayPoint at) {
    const double arm = 6 * scale_;
    line({at.x - arm, at.y}, {at.x + arm, at.y}, 1.5);
    line({at.x, at.y - arm}, {at.x, at.y + arm}, 1.5);
  }

  void dotted(DisplayPoint from, DisplayPoint to) {
    const double length = std::hypot(to.x - from.x, to.y - from.y), pitch = 6 * scale_;
    const int count = static_cast<int>(length / pitch);
    for (int k = 1; k < count; ++k) {
      const double share = double(k) / count;
      lines_.disc({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)}, 1 * scale_, theme::kText, 0.9);
    }
  }

  void line(DisplayPoint from, DisplayPoint to, double width) {
    lines_.segment(from, to, {theme::kBlack, (width + 2) * scale_, 0.5});
    lines_.segment(from, to, {theme::kText, width * scale_, 1});
  }

 private:
  Lines& lines_;
  double scale_;
};

}  // namespace

void drawCaliper(const Caliper& caliper, int number, const ToDisplay& toDisplay, double scale, Lines& lines,
                 Texts& texts) {
  Pen pen(lines, scale);
  DisplayPoint at[3];
  for (int k = 0; k < 3; ++k) at[k] = toDisplay(caliper.points[k]);
  switch (caliper.kind) {
    case CaliperKind::Distance:
      pen.dotted(at[0], at[1]);
      break;
    case CaliperKind::Ellipse: {
      std::vector<DisplayPoint> ring;
      for (const ImagePoint& point : outline(caliper)) ring.push_back(toDisplay(point));
      lines.polyline(ring, {theme::kBlack, 3 * scale, 0.5}, true);
      lines.polyline(ring, {theme::kText, 1.25 * scale, 0.95}, true);
      break;
    }
    case CaliperKind::Angle:
      pen.line(at[0], at[1], 1.25);
      pen.line(at[1], at[2], 1.25);
      break;
  }
  const int marks = caliper.kind == CaliperKind::Angle ? 3 : 2;
  for (int k = 0; k < marks; ++k) pen.cross(at[k]);
  // The list below has the values; the number identifies the measurement.
  const DisplayPoint& last = at[marks - 1];
  texts.put({last.x + 9 * scale, last.y - 2 * scale}, std::to_string(number),
            {12 * scale, theme::kText, true, Across::Left, Along::Bottom});
}

}  // namespace insonate::views
