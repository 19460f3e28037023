#include "WordsArea.h"

#include <QEvent>
#include <QResizeEvent>

namespace insonate::prepare {

WordsArea::WordsArea(QWidget* content) {
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
  setWidgetResizable(true);
  setWidget(content);
  content->installEventFilter(this);
}

QSize WordsArea::sizeHint() const {
  const int width = viewport()->width();
  return {widget()->sizeHint().width(), widget()->heightForWidth(width)};
}

bool WordsArea::eventFilter(QObject* watched, QEvent* event) {
  if (watched == widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
  return QScrollArea::eventFilter(watched, event);
}

void WordsArea::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  if (event->size().width() != event->oldSize().width()) updateGeometry();
}

}  // namespace insonate::prepare
