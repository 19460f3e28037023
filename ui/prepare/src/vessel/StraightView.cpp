#include "StraightView.h"

#include "VesselImage.h"
#include "VesselSession.h"

#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/views/SlicePlane.h>

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate::prepare {
namespace {

/// The image shows at least this height, so that a short vessel is not enlarged beyond its surroundings.
constexpr double kMinHeight_mm = 30;
constexpr int kScale_px = 20;

QString sideOf(Vec3 direction) {
  return ui::qt(views::patientSide(direction));
}

}  // namespace

StraightView::StraightView(PrepareModel& shared, VesselSession& vessel) : shared_(shared), vessel_(vessel) {
  setObjectName(QStringLiteral("straightVessel"));
  setAccessibleName(tr("Straightened vessel"));
  setMinimumHeight(90);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setCursor(Qt::CrossCursor);
}

void StraightView::resample() {
  resampled_.reset();
  redraw();
}

void StraightView::redraw() {
  image_ = {};
  update();
}

void StraightView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  resample();
}

QRectF StraightView::field() const {
  return {0, 0, double(width()), double(height() - kScale_px)};
}

double StraightView::mmPerPx() const {
  return std::max(vessel_.course()->length_mm() / std::max(field().width(), 1.0),
                  kMinHeight_mm / std::max(field().height(), 1.0));
}

double StraightView::placeOf(double along_mm) const {
  return 0.5 * field().width() + (along_mm - 0.5 * vessel_.course()->length_mm()) / mmPerPx();
}

void StraightView::drawImage() {
  const double ratio = devicePixelRatioF();
  const ImageSize size{std::max(1, int(field().width() * ratio)), std::max(1, int(field().height() * ratio)),
                       mmPerPx() / ratio};
  const double from_mm = 0.5 * (vessel_.course()->length_mm() - size.width * size.mm_per_px);
  resampled_ = straightened(vessel_.volumes(), *vessel_.course(), from_mm, vessel_.angle_rad(), size,
                            resampled_ ? &*resampled_ : nullptr);
  image_ = drawnAsSlice(*resampled_, shared_);
  image_.setDevicePixelRatio(ratio);
}

void StraightView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (!vessel_.course()) return;
  if (image_.isNull()) drawImage();
  painter.drawImage(0, 0, image_);
  painter.setRenderHint(QPainter::Antialiasing);
  const double at = placeOf(double(vessel_.frame()) * vessel_.course()->step_mm());
  painter.setPen(QPen(ui::toQColor(views::theme::kCaution), 1));
  painter.drawLine(QPointF(at, 0), QPointF(at, field().bottom()));
  drawScale(painter);
  drawSides(painter);
}

void StraightView::drawScale(QPainter& painter) const {
  const double length_mm = vessel_.course()->length_mm();
  const QFontMetricsF metrics(font());
  painter.setPen(ui::toQColor(views::theme::kQuiet));
  const double top = field().bottom() + 1;
  // Numbers must not touch.
  const double word_px = metrics.horizontalAdvance(QStringLiteral("0000"));
  const double every_mm = word_px * mmPerPx() > 10 ? (word_px * mmPerPx() > 20 ? 50 : 20) : 10;
  for (double mm = 0; mm <= length_mm; mm += 5) {
    const double x = placeOf(mm);
    const bool isNumbered = std::fmod(mm, every_mm) < 0.1;
    painter.drawLine(QPointF(x, top), QPointF(x, top + (isNumbered ? 5 : 3)));
    const QString word = mm + every_mm > length_mm ? tr("%1 mm").arg(mm) : QString::number(mm);
    const double wide = metrics.horizontalAdvance(word);
    if (isNumbered)
      painter.drawText(QPointF(std::clamp(x - wide / 2, 0.0, width() - wide), height() - metrics.descent()), word);
  }
}

void StraightView::drawSides(QPainter& painter) const {
  const VesselCourse& course = *vessel_.course();
  const VesselFrame here = course.frames()[vessel_.frame()];
  const double angle = vessel_.angle_rad();
  const Vec3 down = here.down * std::cos(angle) + here.right * std::sin(angle);
  const QRectF inside = field().adjusted(ui::kSmallGap, 2, -ui::kSmallGap, -2);
  const auto write = [&](int where, const QString& word) {
    painter.setPen(Qt::black);
    painter.drawText(inside.translated(1, 1), where, word);
    painter.setPen(ui::toQColor(views::theme::kText));
    painter.drawText(inside, where, word);
  };
  write(Qt::AlignLeft | Qt::AlignVCenter, sideOf(-course.frames().front().along));
  write(Qt::AlignRight | Qt::AlignVCenter, sideOf(course.frames().back().along));
  write(Qt::AlignHCenter | Qt::AlignTop, sideOf(-down));
  write(Qt::AlignHCenter | Qt::AlignBottom, sideOf(down));
  write(Qt::AlignRight | Qt::AlignTop, tr("rotation %1°").arg(std::lround(angle * 180 / std::numbers::pi) % 360));
}

void StraightView::moveSectionTo(double x) {
  if (!vessel_.course()) return;
  const double along_mm = (x - 0.5 * field().width()) * mmPerPx() + 0.5 * vessel_.course()->length_mm();
  vessel_.moveTo(int(std::lround(along_mm / vessel_.course()->step_mm())));
}

void StraightView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) moveSectionTo(event->localPos().x());
}

void StraightView::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) moveSectionTo(event->localPos().x());
}

}  // namespace insonate::prepare
