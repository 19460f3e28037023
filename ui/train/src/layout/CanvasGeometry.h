#pragma once

#include <QPointF>
#include <algorithm>
#include <cmath>

namespace insonate::train {

/// Returns the distance from a point to the line between two points.
inline double distanceToSegment(QPointF p, QPointF a, QPointF b) {
  const QPointF way = b - a, from = p - a;
  const double length2 = QPointF::dotProduct(way, way);
  const double along = length2 > 0 ? std::clamp(QPointF::dotProduct(from, way) / length2, 0.0, 1.0) : 0;
  const QPointF off = from - along * way;
  return std::hypot(off.x(), off.y());
}

}  // namespace insonate::train
