#pragma once

#include <QKeyEvent>
#include <QWidget>

namespace insonate::ui {

/// Passes letters that are typed while a list or table has the focus to the workspace, whose commands use them as keys.
/// Without this filter, the list would search for rows that begin with these letters.
class LetterKeyFilter final : public QObject {
 public:
  explicit LetterKeyFilter(QWidget* watched) : QObject(watched) { watched->installEventFilter(this); }

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
