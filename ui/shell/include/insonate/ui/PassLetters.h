#pragma once

#include <QKeyEvent>
#include <QWidget>

namespace insonate::ui {

/// Passes letters typed over a list or table to the workspace, which uses them as keys. Without this, the list would
/// search for rows that begin with them.
class PassLetters final : public QObject {
 public:
  explicit PassLetters(QWidget* watched) : QObject(watched) { watched->installEventFilter(this); }

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::KeyPress) return false;
    const QString typed = static_cast<QKeyEvent*>(event)->text();
    const bool printable = !typed.isEmpty() && typed.front().isPrint();
    if (printable) event->ignore();
    return printable;
  }
};

}  // namespace insonate::ui
