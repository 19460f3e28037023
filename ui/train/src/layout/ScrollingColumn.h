#pragma once

#include <QWidget>

namespace insonate::train {

/// A narrow column that scrolls over a foot that stays.
class ScrollingColumn : public QWidget {
 public:
  using QWidget::QWidget;

 protected:
  void setParts(QWidget* scrolled, QWidget* foot);
};

}  // namespace insonate::train
