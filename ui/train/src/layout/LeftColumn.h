#pragma once

#include <QWidget>
#include <functional>

class QVBoxLayout;

namespace insonate::train {

/// The column of controls with a panel above them; both share the column's height.
class LeftColumn final : public QWidget {
 public:
  explicit LeftColumn(QWidget* controls);

  /// Sets the panel above the controls. `setMaximumHeight` is called with the part of the column's height that the
  /// panel may take.
  void setHead(QWidget* head, std::function<void(int maximum_px)> setMaximumHeight);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QVBoxLayout* box_;
  std::function<void(int)> setHeadHeight_;
};

}  // namespace insonate::train
