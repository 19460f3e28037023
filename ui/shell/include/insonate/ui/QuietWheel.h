#pragma once

#include <QEvent>
#include <QWidget>

namespace insonate::ui {

/// Lets the wheel scroll the panel that a number or a choice stands in, until it has the keyboard: who scrolls past a
/// list of opacities does not change them.
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
