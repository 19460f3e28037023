#pragma once

#include <insonate/ultrasound/FovFit.h>

#include <QImage>
#include <QWidget>
#include <array>
#include <optional>

namespace insonate::train {

/// Shows a scanner's image with a field of view drawn over it. The user can drag the sides, corners, face and end of
/// the field of view; dragging inside moves the whole. With the keyboard, G selects the next handle and arrows move the
/// handle (with Shift ten times as far).
class FitCanvas : public QWidget {
  Q_OBJECT

 public:
  explicit FitCanvas(QWidget* parent = nullptr);

  void setPicture(const QImage& picture);
  void setShape(const std::optional<FovShape>& shape);
  const std::optional<FovShape>& shape() const { return shape_; }
  void setMarks(std::vector<PixelPoint> marks);
  /// Starts drawing a line between two points of the image, which determines the scale. The next press sets the first
  /// point; the press after that, or the end of the drag, sets the second.
  void setDrawing(bool drawing);
  bool isDrawing() const { return drawing_; }
  using Line = std::array<PixelPoint, 2>;
  void setLine(const std::optional<Line>& line);
  const std::optional<Line>& line() const { return line_; }
  /// Converts a point of the image to the widget's pixels.
  QPointF placeOf(PixelPoint p) const { return widgetFrom(p); }
  /// Sets the text about the next thing to do, shown if there is no image.
  void setInvitation(const QString& text);

  enum class Handle { None = -1, Left, Right, Face, End, LeftCorner, RightCorner, Whole };
  /// Returns the position of a handle in the widget's pixels; (0, 0) without a shape.
  QPointF placeOf(Handle handle) const;

  QSize sizeHint() const override { return {720, 540}; }

 Q_SIGNALS:
  void shapeChanged();  ///< emitted when the user changes the shape
  void lineDrawn();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  double scale() const;
  QPointF widgetFrom(PixelPoint p) const;
  PixelPoint pictureFrom(QPointF p) const;
  Handle nearest(QPointF at) const;
  void paintLine(QPainter& painter) const;
  void endLine(QPointF at);
  void drag(Handle handle, PixelPoint to, PixelPoint from);

  QImage picture_;
  std::optional<FovShape> shape_;
  std::vector<PixelPoint> marks_;
  QString invitation_;
  Handle chosen_ = Handle::None;
  bool held_ = false, drawing_ = false, begun_ = false;
  QPointF pressedAt_;
  std::optional<Line> line_;
  PixelPoint last_;
};

/// Returns the shape after a handle was dragged to the image point `to`. `from`, the former point, is used only for
/// Handle::Whole. Dragging a side leaves the other side in place.
FovShape draggedTo(FovShape shape, FitCanvas::Handle handle, PixelPoint to, PixelPoint from);

}  // namespace insonate::train
