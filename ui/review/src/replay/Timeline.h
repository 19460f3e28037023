#pragma once

#include <QPixmap>
#include <QWidget>
#include <cstdint>

namespace insonate::review {

class ReviewSession;

/// The attempt from left to right: moments as marks, whose shape and color say how bad they were, and lanes of what
/// the hands did. Click or drag: that time; on a mark, its time. The wheel magnifies about the pointer, a double click
/// shows all of it.
class Timeline : public QWidget {
 public:
  explicit Timeline(ReviewSession& session, QWidget* parent = nullptr);

  int xOf(std::int64_t time_us) const;
  std::int64_t timeAt(int x) const;
  /// The number of the moment whose mark is there, or -1.
  int momentAt(QPoint at) const;
  /// Visible part of the attempt.
  std::int64_t first_us() const { return first_us_; }
  std::int64_t last_us() const { return last_us_; }

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void showAll();
  void setRange(double first_us, double last_us);
  void follow();
  void paintLanes();

  ReviewSession& session_;
  std::int64_t first_us_ = 0, last_us_ = 0;
  QPixmap lanes_;  ///< all but the cursor; null when it is to be painted anew
  bool dragging_ = false;
};

}  // namespace insonate::review
