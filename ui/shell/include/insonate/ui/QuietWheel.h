#pragma once

#include <QEvent>
#include <QWidget>

namespace insonate::ui {

/// Passes the wheel to the surrounding panel until the number field or choice has the keyboard focus, so that scrolling
/// past the field does not change it.
class QuietWheel final : public QObject {
 public:
  explicit QuietWheel(QWidget* watched) : QObject(watched) {
    // The wheel alone does not give the field the keyboard focus.
    watched->setFocusPolicy(Qt::StrongFocus);
    watched->installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus()) return false;
    event->ignore();
    return true;
  }
};

}  // namespace insonate::ui
