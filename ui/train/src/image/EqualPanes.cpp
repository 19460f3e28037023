#include "EqualPanes.h"

#include <QEvent>
#include <QVector>

namespace insonate::train {

void EqualPanes::add(QWidget* pane) {
  pane->setParent(this);
  pane->installEventFilter(this);
  place();
}

void EqualPanes::place() {
  QVector<QWidget*> shown;
  for (QObject* child : children())
    if (auto* widget = qobject_cast<QWidget*>(child); widget && !widget->isHidden()) shown.push_back(widget);
  if (shown.isEmpty()) return;
  const bool stacked = height() > width();
  const int across = stacked ? width() : width() / shown.size(), down = stacked ? height() / shown.size() : height();
  for (int i = 0; i < shown.size(); ++i)
    shown[i]->setGeometry(stacked ? 0 : i * across, stacked ? i * down : 0, across, down);
}

void EqualPanes::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place();
}

bool EqualPanes::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent) place();
  return QWidget::eventFilter(watched, event);
}

}  // namespace insonate::train
