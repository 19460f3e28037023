#pragma once

#include "../attempt/AttemptDigest.h"

#include <insonate/views/Theme.h>

#include <QPainter>
#include <functional>

namespace insonate::review {

/// Positions of a timeline's lanes, in logical pixels from its top left corner.
struct LaneLayout {
  static constexpr int kNames_px = 96, kMarks_px = 24, kBar_px = 12, kDepth_px = 54, kForce_px = 30, kAxis_px = 20;
  static constexpr int kGap_px = 6, kRight_px = 12;
  static constexpr int kHeight_px = kMarks_px + 2 * kBar_px + kDepth_px + kForce_px + kAxis_px + 5 * kGap_px;

  QRect marks, probe, depth, aspirating, force, axis;
  explicit LaneLayout(int width_px);
};

/// Paints an attempt's marks and lanes for the times from `first_us` to `last_us`; `last_us` must be later.
class LanePaint {
 public:
  LanePaint(QPainter& painter, const LaneLayout& layout, const AttemptDigest& attempt, std::int64_t first_us,
            std::int64_t last_us);
  void all();

 private:
  double x(std::int64_t time_us) const;
  void name(const QRect& lane, const QString& text);
  void bars(const QRect& lane, const std::function<bool(const TrackPoint&)>& on, views::Colour colour);
  void depth();
  void force();
  void axis();
  void marks();

  QPainter& painter_;
  const LaneLayout& layout_;
  const AttemptDigest& attempt_;
  std::int64_t first_us_, last_us_;
};

/// Paints a moment's mark around a point: a dot, or a larger and more pointed shape for a more severe error.
void paintMark(QPainter& painter, QPointF middle, const std::optional<Severity>& severity);

}  // namespace insonate::review
