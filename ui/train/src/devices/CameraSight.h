#pragma once

#include <insonate/simulator/CameraHands.h>

#include <QWidget>

namespace insonate::train {

/// Shows the camera's image like a mirror, with the outlines of the bodies that are seen.
class CameraSight final : public QWidget {
  Q_OBJECT

 public:
  explicit CameraSight(QWidget* parent = nullptr);

  void show(CameraView view);
  void clear() { show({}); }
  QSize sizeHint() const override { return {640, 360}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  CameraView view_;
};

}  // namespace insonate::train
