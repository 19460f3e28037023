#pragma once

#include <QWidget>

namespace insonate::train {

/// A narrow scrolling column above a footer that does not scroll.
class ScrollingColumn : public QWidget {
 public:
  using QWidget::QWidget;

 protected:
  void setParts(QWidget* scrolled, QWidget* foot);
};

}  // namespace insonate::train
