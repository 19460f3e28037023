#include "HeatColors.h"

#include <insonate/teaching/HeatMap.h>

namespace insonate::review {

QColor heatColor(double share) {
  const HeatColor color = heatColorOf(share);
  return {color[0], color[1], color[2]};
}

QColor inkOn(const QColor& ground) {
  return needsBlackText({ground.red(), ground.green(), ground.blue()}) ? QColor(Qt::black) : QColor(Qt::white);
}

}  // namespace insonate::review
