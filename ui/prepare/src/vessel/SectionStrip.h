#pragma once

#include <insonate/segmentation/SectionOutline.h>
#include <insonate/segmentation/StraightenedVessel.h>

#include <QImage>
#include <QWidget>
#include <array>
#include <optional>

namespace insonate::prepare {

struct PrepareModel;
class VesselSession;

/// Cross-sections of the vessel about the current section, which is in the middle and larger. The outline of the
/// current section has handles and is dragged with the mouse; a click on another section moves there.
class SectionStrip : public QWidget {
 public:
  /// Distance between neighboring sections of the strip.
  static constexpr double kBetween_mm = 2;

  SectionStrip(PrepareModel& shared, VesselSession& vessel);

  /// Draws the images again, since section or size have changed.
  void resample();
  /// Draws the images again, since labels or window have changed.
  void redraw();
  /// Chooses the part of the sections that is shown, for another course.
  void fitCourse();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  static constexpr int kSections = 7, kMiddle = kSections / 2;

  QRectF cellOf(int section) const;
  /// Number of the frame of a section of the strip; no value beyond the ends of the vessel.
  std::optional<int> frameOf(int section) const;
  QPointF placeOf(const VesselOutline& outline, int ray, const QRectF& cell) const;
  void drawSection(QPainter& painter, int section);
  void drawOutline(QPainter& painter, const VesselOutline& outline, const QRectF& cell) const;
  void drawSides(QPainter& painter, const QRectF& cell) const;
  /// Returns the corner of the current outline at a point; no value if the point is not near the outline.
  std::optional<int> rayAt(QPointF at) const;
  double distance_mm(QPointF at) const;

  PrepareModel& shared_;
  VesselSession& vessel_;
  struct Cell {
    std::optional<ResampledImage> resampled;
    QImage image;  ///< null: must be drawn again
  };
  std::array<Cell, kSections> cells_;
  double width_mm_ = 30;    ///< width of the shown part of a section
  std::optional<int> ray_;  ///< the corner that is dragged
};

}  // namespace insonate::prepare
