#include <insonate/embedded/icons.h>
#include <insonate/ui/Theme.h>

#include <QPainter>
#include <QPixmap>
#include <QSvgRenderer>

namespace insonate::ui {
namespace {

constexpr int kSize = 20;

QPixmap drawn(QByteArray svg, views::Color line, int scale) {
  svg.replace("currentColor", toQColor(line).name().toLatin1());
  QSvgRenderer renderer(svg);
  QPixmap pixmap(kSize * scale, kSize * scale);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  renderer.render(&painter);
  painter.end();
  pixmap.setDevicePixelRatio(scale);
  return pixmap;
}

}  // namespace

QIcon icon(const QString& name, views::Color line) {
  QIcon result;
  for (const auto& file : embedded::icons::files()) {
    if (name != QLatin1String(file.name.data(), int(file.name.size()))) continue;
    const QByteArray svg(file.text.data(), int(file.text.size()));
    for (const int scale : {1, 2, 3}) {
      result.addPixmap(drawn(svg, line, scale), QIcon::Normal);
      result.addPixmap(drawn(svg, views::theme::kQuiet, scale), QIcon::Disabled);
    }
  }
  return result;
}

}  // namespace insonate::ui
