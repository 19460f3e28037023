#include "Swatch.h"

#include <insonate/ui/Theme.h>

#include <QPainter>

namespace insonate::prepare {
namespace {

constexpr int kSwatch_px = 16, kSharp = 3;

}  // namespace

QPixmap swatch(views::Colour colour) {
  QPixmap pixmap(kSwatch_px * kSharp, kSwatch_px * kSharp);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(ui::colour(views::theme::kQuiet), kSharp));
  painter.setBrush(ui::colour(colour));
  painter.drawRoundedRect(QRectF(pixmap.rect()).adjusted(2, 2, -2, -2), 3 * kSharp, 3 * kSharp);
  painter.end();
  pixmap.setDevicePixelRatio(kSharp);
  return pixmap;
}

}  // namespace insonate::prepare
