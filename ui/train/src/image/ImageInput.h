#pragma once

#include "CaliperTool.h"

#include <insonate/views/UltrasoundView.h>

#include <QObject>
#include <QPoint>
#include <QWidget>
#include <functional>

class QMouseEvent;
class QWheelEvent;

namespace insonate::train {

class ImagingModel;
class NeedleMotion;
class ProbeMotion;

/// Mouse input on the ultrasound image: mouse movements move the probe. If a caliper is selected, left clicks measure
/// instead.
class ImageInput : public QObject {
 public:
  ImageInput(ImagingModel& imaging, ProbeMotion& motion, NeedleMotion& needle, views::UltrasoundView& view,
             QWidget& canvas, QObject* parent);

  CaliperTool& calipers() { return calipers_; }
  /// Sets a listener that is called when the mouse changes calipers.
  void setMeasured(std::function<void()> listener) { measured_ = std::move(listener); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool pressed(const QMouseEvent& event);
  bool moved(const QMouseEvent& event);
  bool released(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  bool measuring(const QMouseEvent& event) const;
  views::ImagePoint pictureAt(const QMouseEvent& event) const;

  ImagingModel& imaging_;
  ProbeMotion& motion_;
  NeedleMotion& needle_;
  views::UltrasoundView& view_;
  QWidget& canvas_;
  CaliperTool calipers_;
  std::function<void()> measured_;
  Qt::MouseButton held_ = Qt::NoButton;
  QPointF last_;
  qint64 lastWheel_ms_ = -100000;
};

}  // namespace insonate::train
