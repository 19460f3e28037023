#include "EqualColumns.h"

#include <QEvent>
#include <QVector>

namespace insonate::train {

void EqualColumns::add(QWidget* column) {
  column->setParent(this);
  column->installEventFilter(this);
  place();
}

void EqualColumns::place() {
  QVector<QWidget*> shown;
  for (QObject* child : children())
    if (auto* widget = qobject_cast<QWidget*>(child); widget && !widget->isHidden()) shown.push_back(widget);
  if (shown.isEmpty()) return;
  const int each = width() / shown.size();
  for (int i = 0; i < shown.size(); ++i) shown[i]->setGeometry(i * each, 0, each, height());
}

void EqualColumns::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  place();
}

bool EqualColumns::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent) place();
  return QWidget::eventFilter(watched, event);
}

}  // namespace insonate::train
