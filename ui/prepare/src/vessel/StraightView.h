#pragma once

#include <insonate/segmentation/StraightenedVessel.h>

#include <QImage>
#include <QWidget>
#include <optional>

namespace insonate::prepare {

struct PrepareModel;
class VesselSession;

/// The straightened vessel: the course from left to right, with a scale in millimeters along it, the sides of the
/// patient at the edges, and a line at the current section. A click or drag moves the section.
class StraightView : public QWidget {
 public:
  StraightView(PrepareModel& shared, VesselSession& vessel);

  /// Draws the image again, since course, rotation or size have changed.
  void resample();
  /// Draws the image again, since labels or window have changed.
  void redraw();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  QRectF field() const;
  double mmPerPx() const;
  /// Horizontal position of a distance along the course.
  double placeOf(double along_mm) const;
  void drawImage();
  void drawScale(QPainter& painter) const;
  void drawSides(QPainter& painter) const;
  void moveSectionTo(double x);

  PrepareModel& shared_;
  VesselSession& vessel_;
  std::optional<ResampledImage> resampled_;
  QImage image_;  ///< null: must be drawn again
};

}  // namespace insonate::prepare
