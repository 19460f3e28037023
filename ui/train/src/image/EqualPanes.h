#pragma once

#include <QWidget>

namespace insonate::train {

/// Shows its visible children side by side, or above each other where there is more height than width, each exactly as
/// large as the others, so that what they draw at the size of their window is equally large.
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
