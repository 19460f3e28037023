#pragma once

#include <QPointer>
#include <QWidget>

namespace insonate::train {

/// Marks one control of the window with a frame and an arrow in the accent color; a button also becomes the primary
/// button. Takes neither focus nor clicks.
class ControlMark final : public QWidget {
 public:
  /// `window`: widget over whose controls the mark is drawn.
  explicit ControlMark(QWidget& window);

  /// Marks the control with this object name, with frame and arrow while the control is fully visible; empty: no
  /// control. Call this function again after the layout may have changed.
  void pointAt(const QString& control);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QPointer<QWidget> control_;
};

}  // namespace insonate::train
