#pragma once

#include <insonate/views/UltrasoundView.h>

#include <QObject>
#include <QPointF>
#include <optional>

class QMouseEvent;
class QWidget;

namespace insonate::train {

class ImagingModel;

/// Moves and resizes the color box with the mouse: dragging a border moves the box, dragging a corner moves the corner.
class ColorBox : public QObject {
 public:
  ColorBox(ImagingModel& imaging, views::UltrasoundView& view, QWidget& canvas, QObject* parent);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// Part of the box: a corner by its index in colorBoxCorners(), or kBorder.
  static constexpr int kBorder = 4;
  /// Place in the box's coordinates.
  struct Place {
    double across = 0;  ///< fraction of the field of view from its left edge
    double range_mm = 0;
  };
  QPointF pixelOf(const QMouseEvent& event) const;
  Place placeOf(QPointF at_px) const;
  std::optional<int> partAt(QPointF at_px) const;
  void drag(Place to);

  ImagingModel& imaging_;
  views::UltrasoundView& view_;
  QWidget& canvas_;
  std::optional<int> held_;
  Place last_;
};

}  // namespace insonate::train
