#pragma once

#include <QWidget>

namespace insonate::train {

/// Shows its visible children at equal size: side by side, or above each other if the widget is higher than wide.
/// Images that fit their panes therefore have equal scale.
class EqualPanes : public QWidget {
 public:
  using QWidget::QWidget;

  void add(QWidget* pane);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();
};

}  // namespace insonate::train
