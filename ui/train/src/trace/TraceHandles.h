#pragma once

#include <insonate/views/UltrasoundView.h>

#include <QObject>
#include <QPointF>
#include <optional>

class QMouseEvent;
class QWidget;

namespace insonate::train {

class ImagingModel;
class TraceModel;

/// Draws the gate of PW Doppler and the line of M-mode over the image, and moves them with the mouse: dragging the gate
/// moves it, dragging its line moves the line, and dragging an end of the line of flow turns this line.
class TraceHandles : public QObject {
  Q_OBJECT

 public:
  TraceHandles(ImagingModel& imaging, TraceModel& trace, views::UltrasoundView& view, QWidget& canvas, QObject* parent);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Part { Gate, Line, Flow, MMode };
  void draw();
  QPointF pixelOf(const QMouseEvent& event) const;
  QPointF onDisplay(Vec3 point_mm) const;
  std::optional<Part> partAt(QPointF at_px) const;
  void drag(QPointF to_px);
  /// Half of the line of flow, probe frame.
  Vec3 flowArm_mm() const;

  ImagingModel& imaging_;
  TraceModel& trace_;
  views::UltrasoundView& view_;
  QWidget& canvas_;
  std::optional<Part> held_;
};

}  // namespace insonate::train
