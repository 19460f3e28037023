#include "TraceStrip.h"

#include <insonate/ui/Theme.h>

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

namespace insonate::train {
namespace {

constexpr double kAxisRoom_px = 52, kRightMargin_px = 10, kTopMargin_px = 8, kTimeRoom_px = 20;
constexpr int kGapColumns = 3;

}  // namespace

TraceStrip::TraceStrip(int rows, double step_s, QWidget* parent) : QWidget(parent), rows_(rows), step_s_(step_s) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  reset();
}

void TraceStrip::setDuration(double seconds) {
  if (seconds == duration_s_) return;
  duration_s_ = seconds;
  clear();
}

void TraceStrip::clear() {
  reset();
}

void TraceStrip::reset() {
  const int width = std::max(2, int(std::lround(duration_s_ / step_s_)));
  if (ring_.width() != width) ring_ = QImage(width, rows_, QImage::Format_Grayscale8);
  ring_.fill(0);
  times_s_.assign(std::size_t(width), std::numeric_limits<double>::quiet_NaN());
  next_ = count_ = 0;
  update();
}

void TraceStrip::append(double time_s, std::span<const std::uint8_t> gray) {
  const double last_s = count_ > 0 ? times_s_[(next_ + times_s_.size() - 1) % times_s_.size()] : time_s;
  // Time that passes while the image is frozen takes no room.
  if (std::abs(time_s - last_s) > 4 * step_s_)
    for (int i = 0; i < kGapColumns; ++i) put(std::numeric_limits<double>::quiet_NaN(), {});
  put(time_s, gray);
  update();
}

void TraceStrip::put(double time_s, std::span<const std::uint8_t> gray) {
  for (int row = 0; row < rows_; ++row)
    ring_.scanLine(row)[next_] = std::size_t(row) < gray.size() ? gray[std::size_t(row)] : 0;
  times_s_[next_] = time_s;
  next_ = (next_ + 1) % times_s_.size();
  ++count_;
}

int TraceStrip::grayAt(std::size_t back, int row) const {
  const std::size_t column = (next_ + 2 * times_s_.size() - 1 - back % times_s_.size()) % times_s_.size();
  return ring_.constScanLine(row)[column];
}

/// A mark at the bottom for each second, and for each half.
void TraceStrip::drawTimes(QPainter& painter, double left, double right, double bottom) const {
  const std::size_t width = times_s_.size();
  painter.setPen(ui::toQColor(views::theme::kQuiet));
  for (std::size_t i = 1; i < width; ++i) {
    const double before = times_s_[(next_ + i - 1) % width], now = times_s_[(next_ + i) % width];
    if (!(now > before) || std::floor(2 * now) == std::floor(2 * before)) continue;
    const double x = left + (right - left) * double(i) / double(width);
    const bool isSecond = std::floor(now) != std::floor(before);
    painter.drawLine(QPointF(x, bottom), QPointF(x, bottom + (isSecond ? 7 : 3)));
  }
  painter.drawText(QRectF(0, bottom + 2, kAxisRoom_px - 6, 16), Qt::AlignRight | Qt::AlignTop, tr("1 s"));
}

void TraceStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.fillRect(rect(), Qt::black);
  QFont font = painter.font();
  font.setPointSizeF(font.pointSizeF() - 1);
  painter.setFont(font);
  const double left = kAxisRoom_px, right = std::max(left + 10, width() - kRightMargin_px), top = kTopMargin_px;
  const double bottom = std::max(top + 10, height() - kTimeRoom_px);
  const double older = double(ring_.width()) - double(next_), seam = left + (right - left) * older / ring_.width();
  painter.drawImage(QRectF(left, top, seam - left, bottom - top), ring_, QRectF(double(next_), 0, older, rows_));
  painter.drawImage(QRectF(seam, top, right - seam, bottom - top), ring_, QRectF(0, 0, double(next_), rows_));
  drawTimes(painter, left, right, bottom);
  drawAxis(painter, left, right, top, bottom);
}

}  // namespace insonate::train
