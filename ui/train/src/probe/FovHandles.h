#pragma once

#include <insonate/views/UltrasoundView.h>

#include <QObject>
#include <QWidget>
#include <optional>

class QKeyEvent;
class QMouseEvent;

namespace insonate::train {

class History;
class ImagingModel;
class StatusLine;

/// Handles on the live image that change the probe's field of view: its angle (or width), the face's radius, the depth.
/// The user drags the handles with the mouse. With the keyboard, G selects the next handle, and Ctrl with the arrows
/// moves the handle.
class FovHandles : public QObject {
  Q_OBJECT

 public:
  FovHandles(StatusLine& status, History& history, ImagingModel& imaging, views::UltrasoundView& view, QWidget& canvas,
             QObject* parent);

  void setActive(bool active);
  bool isActive() const { return active_; }
  /// Tells whether a handle is held; the image must then keep its scale.
  bool isHeld() const { return held_; }
  /// Returns the part of the imaging plane to show: the field of view plus space for dragging outward.
  views::ImageBounds roomFor(const views::ImageBounds& fieldOfView) const;

  enum class Handle { None = -1, RightSide, LeftSide, Face, Depth };
  /// Returns the position of a handle in display pixels of the view.
  views::DisplayPoint displayOf(Handle handle) const;

 Q_SIGNALS:
  void released();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  Handle nearest(const QMouseEvent& event) const;
  views::DisplayPoint pointOf(const QMouseEvent& event) const;
  views::ImagePoint placeOf(Handle handle) const;
  bool key(const QKeyEvent& event, bool act);
  void drag(views::ImagePoint to);
  void step(double amount);
  void refresh();

  StatusLine& status_;
  History& history_;
  ImagingModel& imaging_;
  views::UltrasoundView& view_;
  QWidget& canvas_;
  bool active_ = false, held_ = false;
  Handle chosen_ = Handle::None;
};

}  // namespace insonate::train
