#include "WrappedList.h"

#include <QPainter>
#include <QPixmap>
#include <algorithm>

namespace insonate::review {
namespace {

constexpr int kMark_px = 20;
/// Space of a row beside and above its text: the mark, and the padding of the style sheet.
constexpr int kBeside_px = kMark_px + 24, kAround_px = 14;

}  // namespace

WrappedList::WrappedList(QWidget* parent) : QListWidget(parent) {
  setWordWrap(true);
  setIconSize({kMark_px, kMark_px});
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setResizeMode(QListView::Adjust);
  setUniformItemSizes(false);
}

QIcon WrappedList::markIcon(double pixelRatio, const std::function<void(QPainter&, QPointF)>& paint) {
  QPixmap pixmap(QSize(kMark_px, kMark_px) * pixelRatio);
  pixmap.setDevicePixelRatio(pixelRatio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  paint(painter, {kMark_px / 2.0, kMark_px / 2.0});
  QIcon icon;
  for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Selected}) icon.addPixmap(pixmap, mode);
  return icon;
}

void WrappedList::resizeEvent(QResizeEvent* event) {
  QListWidget::resizeEvent(event);
  fitRows();
}

/// Qt computes the height of rows without the padding of the style sheet, and would cut off texts.
void WrappedList::fitRows() {
  const QRect room(0, 0, std::max(1, viewport()->width() - kBeside_px), QWIDGETSIZE_MAX);
  for (int row = 0; row < count(); ++row) {
    const int height = fontMetrics().boundingRect(room, Qt::TextWordWrap, item(row)->text()).height();
    // Qt elides the last line if the fractions of the lines' heights do not fit.
    const int fractions = height / fontMetrics().height();
    item(row)->setSizeHint({room.width(), std::max(height + fractions, kMark_px) + kAround_px});
  }
}

}  // namespace insonate::review
