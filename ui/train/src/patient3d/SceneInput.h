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

class HapticControl;
class NeedleMotion;
class ProbeMotion;

/// Mouse input in 3D. On the skin, the mouse moves the probe and, with Ctrl, the needle's entry point. Beside the body,
/// or with the middle button, the mouse moves the camera.
class SceneInput : public QObject {
 public:
  SceneInput(HapticControl& hands, ProbeMotion& motion, NeedleMotion& needle, views::SceneView& view, QWidget& canvas,
             QObject* parent);

  /// Sets the tray's pose; empty: no tray.
  void setTray(const std::optional<Transform>& patientFromTray) { tray_ = patientFromTray; }
  /// Sets a listener that is called when the tray is clicked.
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

  HapticControl& hands_;
  ProbeMotion& motion_;
  NeedleMotion& needle_;
  views::SceneView& view_;
  QWidget& canvas_;
  bool isOnTray(const QMouseEvent& event);
  std::optional<Transform> tray_;
  std::function<void()> trayTaken_;
  Drag drag_ = Drag::None;
  bool begun_ = false;  ///< true: the mouse has moved too far for a click
  QPointF from_, last_;
};

}  // namespace insonate::train
