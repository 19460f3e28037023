#pragma once

#include <insonate/views/SceneView.h>

#include <QObject>
#include <QPoint>
#include <QWidget>
#include <functional>
#include <optional>
#include <utility>

class QMouseEvent;
class QWheelEvent;

namespace insonate::train {

class HandsControl;
class NeedleMotion;
class ProbeMotion;

/// Mouse in 3D: on the skin it has the probe, with Ctrl the needle's entry, beside the body and with the middle button
/// the camera.
class SceneInput : public QObject {
 public:
  SceneInput(HandsControl& hands, ProbeMotion& motion, NeedleMotion& needle, views::SceneView& view, QWidget& canvas,
             QObject* parent);

  /// Sets the tray's place; none: there is no tray.
  void setTray(const std::optional<Transform>& patientFromTray) { tray_ = patientFromTray; }
  /// Called when it is clicked.
  void setTrayTaken(std::function<void()> listener) { trayTaken_ = std::move(listener); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Drag { None, Slide, Rotate, Needle, Camera };
  bool pressed(const QMouseEvent& event);
  bool moved(const QMouseEvent& event);
  bool released(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  views::Pointer pointer(const QMouseEvent& event) const;

  HandsControl& hands_;
  ProbeMotion& motion_;
  NeedleMotion& needle_;
  views::SceneView& view_;
  QWidget& canvas_;
  bool isOnTray(const QMouseEvent& event);
  std::optional<Transform> tray_;
  std::function<void()> trayTaken_;
  Drag drag_ = Drag::None;
  bool begun_ = false;  ///< far enough to be no click
  QPointF from_, last_;
};

}  // namespace insonate::train
