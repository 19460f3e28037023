#pragma once

#include <QWidget>
#include <functional>

class QVBoxLayout;

namespace insonate::train {

/// The column of the controls, with a panel over them that shares its height.
class LeftColumn final : public QWidget {
 public:
  explicit LeftColumn(QWidget* controls);

  /// Puts a panel over the controls. `setMaximumHeight` is called with its share of the column's height.
  void setHead(QWidget* head, std::function<void(int maximum_px)> setMaximumHeight);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QVBoxLayout* box_;
  std::function<void(int)> setHeadHeight_;
};

}  // namespace insonate::train
