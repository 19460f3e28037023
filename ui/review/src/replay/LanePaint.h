#pragma once

#include "../attempt/AttemptDigest.h"

#include <insonate/views/Theme.h>

#include <QPainter>
#include <QString>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace insonate::review {

/// A comment in the form in which the timeline shows it.
struct TimelineComment {
  std::int64_t time_us = 0;
  QString words{};  ///< author and text
  bool isUnread = false;
};

/// Positions of a timeline's lanes, in logical pixels from its top left corner.
struct LaneLayout {
  static constexpr int kNames_px = 96, kMarks_px = 24, kBar_px = 12, kDepth_px = 54, kForce_px = 30, kAxis_px = 20;
  static constexpr int kGap_px = 6, kRight_px = 12, kComments_px = 18;

  QRect marks, comments, probe, depth, aspirating, force, axis;  ///< comments: lane of the comments; null if there are
                                                                 ///< no comments
  LaneLayout(int width_px, bool hasComments);
  int height_px() const { return axis.bottom() + 1; }
};

/// Paints an attempt's marks and lanes for the times from `first_us` to `last_us`; `last_us` must be later.
class LanePaint {
 public:
  LanePaint(QPainter& painter, const LaneLayout& layout, const AttemptDigest& attempt, std::int64_t first_us,
            std::int64_t last_us);
  void all();
  void comments(const std::vector<TimelineComment>& comments);

 private:
  double x(std::int64_t time_us) const;
  void name(const QRect& lane, const QString& text);
  void bars(const QRect& lane, const std::function<bool(const TrackPoint&)>& on, views::Color color);
  void depth();
  void force();
  void axis();
  void marks();

  QPainter& painter_;
  const LaneLayout& layout_;
  const AttemptDigest& attempt_;
  std::int64_t first_us_, last_us_;
};

/// Paints a comment's mark around a point: a speech balloon, filled and with a dot if the comment is unread.
void paintComment(QPainter& painter, QPointF middle, bool isUnread);

/// Paints a moment's mark around a point: a dot, or a larger and more pointed shape for a more severe error.
void paintMark(QPainter& painter, QPointF middle, const std::optional<Severity>& severity);

}  // namespace insonate::review
