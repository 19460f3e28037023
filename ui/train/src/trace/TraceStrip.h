#pragma once

#include <QImage>
#include <QWidget>
#include <cstdint>
#include <span>
#include <vector>

class QPainter;

namespace insonate::train {

/// A strip under the image in which columns of gray values scroll from right to left, with marks of time. Allocates no
/// memory for a column.
class TraceStrip : public QWidget {
  Q_OBJECT

 public:
  TraceStrip(int rows, double step_s, QWidget* parent = nullptr);

  /// Sets the duration that the strip shows; clears it if the duration has changed.
  void setDuration(double seconds);
  /// Appends the column of a time. A gap in time leaves a narrow gap in the strip.
  void append(double time_s, std::span<const std::uint8_t> gray);
  virtual void clear();
  /// Returns the number of columns since clear().
  std::size_t columns() const { return count_; }
  /// Returns the gray value of a column, counted back from the latest, which is 0.
  int grayAt(std::size_t back, int row) const;

  QSize sizeHint() const override { return {320, 170}; }
  QSize minimumSizeHint() const override { return {160, 110}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  /// Draws the axis at the left, whose rows lie between `top` and `bottom`.
  virtual void drawAxis(QPainter& painter, double left, double right, double top, double bottom) = 0;
  int rows() const { return rows_; }
  /// Returns the number of columns that the strip shows.
  std::size_t shownColumns() const { return times_s_.size(); }

 private:
  void reset();
  void put(double time_s, std::span<const std::uint8_t> gray);
  void drawTimes(QPainter& painter, double left, double right, double bottom) const;

  int rows_;
  double step_s_, duration_s_ = 5;
  QImage ring_;                  ///< columns in a ring; next_ is the oldest
  std::vector<double> times_s_;  ///< of the columns; NaN: a gap
  std::size_t next_ = 0, count_ = 0;
};

}  // namespace insonate::train
