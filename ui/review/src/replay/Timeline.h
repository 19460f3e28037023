#pragma once

#include "LanePaint.h"

#include <QPixmap>
#include <QWidget>
#include <cstdint>
#include <vector>

namespace insonate::review {

class ReviewSession;

/// Shows the attempt from left to right: moments as marks, whose shape and color show their severity, and lanes of the
/// movements of probe and needle. Comments, if there are any, have a lane of their own. A click or drag sets the time;
/// a click on a mark sets the mark's time. The wheel zooms about the pointer; a double click shows the whole attempt.
class Timeline : public QWidget {
 public:
  explicit Timeline(ReviewSession& session, QWidget* parent = nullptr);

  int xOf(std::int64_t time_us) const;
  std::int64_t timeAt(int x) const;
  /// Returns the number of the moment whose mark is at this point, or -1.
  int momentAt(QPoint at) const;
  /// Returns the number of the comment whose mark is at this point, or -1.
  int commentAt(QPoint at) const;
  void setComments(std::vector<TimelineComment> comments);
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
  LaneLayout layout() const { return {width(), !comments_.empty()}; }
  std::optional<std::int64_t> markAt(QPoint at) const;
  QString wordsAt(QPoint at) const;

  ReviewSession& session_;
  std::int64_t first_us_ = 0, last_us_ = 0;
  QPixmap lanes_;  ///< all contents except the cursor; null if they must be painted again
  std::vector<TimelineComment> comments_;
  bool dragging_ = false;
};

}  // namespace insonate::review
