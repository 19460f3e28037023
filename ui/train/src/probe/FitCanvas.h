#pragma once

#include <insonate/ultrasound/FovFit.h>

#include <QImage>
#include <QWidget>
#include <array>
#include <optional>

namespace insonate::train {

/// An image of a machine with a field of view over it, whose sides, corners, face and end can be dragged; inside it
/// all moves. With the keyboard, G goes from handle to handle and arrows move it (Shift: ten times as far).
class FitCanvas : public QWidget {
  Q_OBJECT

 public:
  explicit FitCanvas(QWidget* parent = nullptr);

  void setPicture(const QImage& picture);
  void setShape(const std::optional<FovShape>& shape);
  const std::optional<FovShape>& shape() const { return shape_; }
  void setMarks(std::vector<PixelPoint> marks);
  /// The next press begins a line between two points of the image, which decides the scale; the next one, or the end
  /// of the drag, ends it.
  void setDrawing(bool drawing);
  bool isDrawing() const { return drawing_; }
  using Line = std::array<PixelPoint, 2>;
  void setLine(const std::optional<Line>& line);
  const std::optional<Line>& line() const { return line_; }
  /// Position in the widget's pixels.
  QPointF placeOf(PixelPoint p) const { return widgetFrom(p); }
  /// Sets the next thing to do, shown while there is no image.
  void setInvitation(const QString& text);

  enum class Handle { None = -1, Left, Right, Face, End, LeftCorner, RightCorner, Whole };
  /// Position of a handle in the widget's pixels; (0, 0) without a shape.
  QPointF placeOf(Handle handle) const;

  QSize sizeHint() const override { return {720, 540}; }

 Q_SIGNALS:
  void shapeChanged();  ///< by hand
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

/// The shape after a handle was brought to a point of the image; `from` is where it was, for Whole. Sides move alone:
/// the other side stays.
FovShape draggedTo(FovShape shape, FitCanvas::Handle handle, PixelPoint to, PixelPoint from);

}  // namespace insonate::train
