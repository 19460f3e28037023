#include "MModeStrip.h"

#include <insonate/ui/Theme.h>
#include <insonate/ultrasound/MMode.h>

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace insonate::train {
namespace {

constexpr double kLongestInterval_s = 0.4;

}  // namespace

MModeStrip::MModeStrip(QWidget* parent)
    : TraceStrip(kRows, kColumn_s, parent), before_(kRows), now_(kRows), between_(kRows) {
  setObjectName("mMode");
  setToolTip(tr("The echoes of one scanline over time (M-mode), with depth in mm"));
  setAccessibleName(tr("M-mode: one scanline over time"));
}

void MModeStrip::append(const LiveFrame& frame, double across) {
  const ImagingSetup& setup = *frame.setup;
  if (setup.settings.depth_mm != depth_mm_) clear();
  lineOverTime(frame.image, setup.probe, setup.settings, across, now_);
  const auto last = static_cast<long long>(std::floor(frame.time_s / kColumn_s));
  const double interval_s = frame.time_s - before_s_;
  const bool continues = columns() > 0 && across == across_ && interval_s > 0 && interval_s < kLongestInterval_s;
  if (!continues) {
    column_ = last;
    TraceStrip::append(double(column_) * kColumn_s, now_);
  }
  for (; column_ < last; ++column_) {
    const double part = std::clamp((double(column_ + 1) * kColumn_s - before_s_) / interval_s, 0.0, 1.0);
    for (std::size_t row = 0; row < between_.size(); ++row)
      between_[row] = static_cast<std::uint8_t>(std::lround(before_[row] + part * (now_[row] - before_[row])));
    TraceStrip::append(double(column_ + 1) * kColumn_s, between_);
  }
  before_.swap(now_);
  before_s_ = frame.time_s, across_ = across, depth_mm_ = setup.settings.depth_mm;
}

void MModeStrip::repeatUntil(double time_s) {
  if (columns() == 0) return;
  const auto last = static_cast<long long>(std::floor(time_s / kColumn_s));
  for (; column_ < last; ++column_) TraceStrip::append(double(column_ + 1) * kColumn_s, before_);
  before_s_ = std::max(before_s_, time_s);
}

void MModeStrip::drawAxis(QPainter& painter, double left, double /*right*/, double top, double bottom) {
  if (depth_mm_ <= 0) return;
  const double step_mm = depth_mm_ > 100 ? 50 : depth_mm_ > 50 ? 20 : 10;
  painter.setPen(ui::toQColor(views::theme::kQuiet));
  for (double depth_mm = 0; depth_mm <= depth_mm_ + 1e-6; depth_mm += step_mm) {
    const double y = top + (bottom - top) * depth_mm / depth_mm_;
    painter.drawLine(QPointF(left - 4, y), QPointF(left, y));
    // The unit of time is at the bottom.
    if (y > bottom - 8) continue;
    const QString text = depth_mm > 0 ? QString::number(depth_mm) : tr("mm");
    painter.drawText(QRectF(0, y - 8, left - 7, 16), Qt::AlignRight | Qt::AlignVCenter, text);
  }
}

}  // namespace insonate::train
