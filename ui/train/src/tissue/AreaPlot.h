#pragma once

#include <QPointF>
#include <QWidget>
#include <vector>

class QPainter;
class QRectF;

namespace insonate {
struct LiveDeformation;
}

namespace insonate::train {

/// Plots the areas of vein and artery against the probe's force: earlier points as a trace, and the present point.
/// Allocates no memory once the trace has its maximum length.
class AreaPlot final : public QWidget {
 public:
  static constexpr std::size_t kMost = 4000;  ///< maximum number of points; the oldest are dropped first

  explicit AreaPlot(QWidget* parent = nullptr);

  /// Adds the point of a new live image to the trace, if the probe compresses tissue.
  void add(const LiveDeformation& press);
  /// Shows the point of the image on display without adding the point to the trace. Shows no point if there is no
  /// vessel in the plane.
  void show(const LiveDeformation& press);
  void clear();
  std::size_t points() const { return trace_.size(); }

  QSize sizeHint() const override { return {320, 150}; }
  QSize minimumSizeHint() const override { return {160, 110}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// A point of the plot: force, and areas in % of the area in the CT; an area is below 0 if the vessel is not in the
  /// plane.
  struct Point {
    float force_N = 0, vein = -1, artery = -1;
  };
  static Point pointOf(const LiveDeformation& press);
  void grow(const Point& point);
  void describe();
  void drawAxes(QPainter& painter, const QRectF& room) const;
  void drawVessel(QPainter& painter, const QRectF& room, float Point::*area, const QColor& color) const;
  QPointF at(const QRectF& room, double force_N, double area) const;

  std::vector<Point> trace_;
  std::size_t next_ = 0;  ///< index of the oldest point, which is overwritten next, once the trace is full
  Point now_;
  double maxForce_N_ = 2, maxArea_ = 120;
};

}  // namespace insonate::train
