#pragma once

#include <QPointF>
#include <QWidget>
#include <vector>

class QPainter;
class QRectF;

namespace insonate {
struct LivePress;
}

namespace insonate::train {

/// The areas of vein and artery against the force of the probe: where they have been, and where they are now. Nothing
/// is allocated once the trace is as long as it gets.
class AreaPlot final : public QWidget {
 public:
  static constexpr std::size_t kMost = 4000;  ///< points kept; the oldest go first

  explicit AreaPlot(QWidget* parent = nullptr);

  /// A new live image's: its point is kept where the probe presses.
  void add(const LivePress& press);
  /// The point of the image on display, which is not kept; none where no vessel is in the plane.
  void show(const LivePress& press);
  void clear();
  std::size_t points() const { return trace_.size(); }

  QSize sizeHint() const override { return {320, 150}; }
  QSize minimumSizeHint() const override { return {160, 110}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// Areas in % of the area in the CT; below 0 where there is no such vessel.
  struct Point {
    float force_N = 0, vein = -1, artery = -1;
  };
  static Point pointOf(const LivePress& press);
  void grow(const Point& point);
  void describe();
  void drawAxes(QPainter& painter, const QRectF& room) const;
  void drawVessel(QPainter& painter, const QRectF& room, float Point::*area, const QColor& colour) const;
  QPointF at(const QRectF& room, double force_N, double area) const;

  std::vector<Point> trace_;
  std::size_t next_ = 0;  ///< where the next one goes once the trace is full
  Point now_;
  double mostForce_N_ = 2, mostArea_ = 120;
};

}  // namespace insonate::train
