#pragma once

#include <QWidget>

namespace insonate::train {

/// Shows its visible children side by side, each exactly as wide as the others, so that what they draw at the size of
/// their window is equally large.
class EqualColumns : public QWidget {
 public:
  using QWidget::QWidget;

  void add(QWidget* column);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();
};

}  // namespace insonate::train
