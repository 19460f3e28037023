#pragma once

#include <QEvent>
#include <QWidget>

namespace insonate::ui {

/// Lets the wheel scroll the panel around a number or a choice until that has the keyboard focus, so that scrolling
/// past it does not change it.
class QuietWheel final : public QObject {
 public:
  explicit QuietWheel(QWidget* watched) : QObject(watched) {
    // By the wheel alone, nothing gets the keyboard.
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
