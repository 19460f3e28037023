#include "SectionStrip.h"

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

constexpr int kCaption_px = 18, kGap_px = 4;
/// Distance from the outline within which it can be dragged.
constexpr double kReach_px = 10;
/// Minimum distance between handles: more handles would hide the wall.
constexpr double kBetweenHandles_px = 12;

}  // namespace

SectionStrip::SectionStrip(PrepareModel& shared, VesselSession& vessel) : shared_(shared), vessel_(vessel) {
  setObjectName(QStringLiteral("vesselSections"));
  setAccessibleName(tr("Cross-sections of the vessel"));
  setMinimumHeight(110);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setMouseTracking(true);
}

void SectionStrip::resample() {
  cells_ = {};
  update();
}

void SectionStrip::redraw() {
  for (Cell& cell : cells_) cell.image = {};
  update();
}

void SectionStrip::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  resample();
}

void SectionStrip::fitCourse() {
  constexpr double kAround = 2.4, kMin_mm = 16, kMax_mm = 70;
  double largest_mm = 0;
  if (const VesselCourse* course = vessel_.course())
    for (std::size_t frame = 0; frame < course->frames().size(); frame += 5)
      largest_mm = std::max(largest_mm, std::sqrt(vessel_.outlineAt(frame).area_mm2() / std::numbers::pi));
  width_mm_ = std::clamp(2 * kAround * largest_mm, kMin_mm, kMax_mm);
  resample();
}

/// Cells are square; the middle cell has the whole height as long as the others keep half of its size.
QRectF SectionStrip::cellOf(int section) const {
  const double high = height() - kCaption_px, free = width() - (kSections - 1) * kGap_px;
  const double large = std::min(high, free / (1 + 0.5 * (kSections - 1)));
  const double small = std::min(large, (free - large) / (kSections - 1));
  const double left = 0.5 * (width() - large - (kSections - 1) * (small + kGap_px));
  const double x = left + section * (small + kGap_px) + (section > kMiddle ? large - small : 0);
  const double side = section == kMiddle ? large : small;
  return {x, 0.5 * (high - side), side, side};
}

std::optional<int> SectionStrip::frameOf(int section) const {
  const VesselCourse& course = *vessel_.course();
  const int frame = int(vessel_.frame()) + int(std::lround((section - kMiddle) * kBetween_mm / course.step_mm()));
  if (frame < 0 || frame >= int(course.frames().size())) return std::nullopt;
  return frame;
}

QPointF SectionStrip::placeOf(const VesselOutline& outline, int ray, const QRectF& cell) const {
  const double angle = 2 * std::numbers::pi * ray / VesselOutline::kRays;
  const double px = outline.radius_mm[std::size_t(ray)] * cell.width() / width_mm_;
  return cell.center() + QPointF(std::cos(angle) * px, std::sin(angle) * px);
}

void SectionStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (!vessel_.course()) return;
  painter.setRenderHint(QPainter::Antialiasing);
  for (int section = 0; section < kSections; ++section) drawSection(painter, section);
}

void SectionStrip::drawSection(QPainter& painter, int section) {
  const auto frame = frameOf(section);
  if (!frame) return;
  const QRectF cell = cellOf(section);
  auto& [resampled, image] = cells_[std::size_t(section)];
  if (image.isNull()) {
    const int side = std::max(1, int(cell.width() * devicePixelRatioF()));
    resampled = crossSection(vessel_.volumes(), vessel_.course()->frames()[std::size_t(*frame)],
                             {side, side, width_mm_ / side}, resampled ? &*resampled : nullptr);
    image = drawnAsSlice(*resampled, shared_);
  }
  painter.drawImage(cell, image);
  const bool isMiddle = section == kMiddle;
  const double along_mm = *frame * vessel_.course()->step_mm();
  QString caption = QString::number(along_mm, 'f', 0);
  if (isMiddle) {
    const VesselOutline outline = vessel_.outline();
    caption = tr("%1 mm   ⌀ %2 mm")
                  .arg(along_mm, 0, 'f', 0)
                  .arg(2 * std::sqrt(outline.area_mm2() / std::numbers::pi), 0, 'f', 1);
    painter.save();
    painter.setClipRect(cell);
    drawOutline(painter, outline, cell);
    painter.restore();
    drawSides(painter, cell);
  }
  painter.setPen(ui::toQColor(isMiddle ? views::theme::kCaution : views::theme::kLine));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(cell);
  painter.setPen(ui::toQColor(isMiddle ? views::theme::kText : views::theme::kQuiet));
  painter.drawText(QRectF(cell.left() - kGap_px, cell.bottom() + 1, cell.width() + 2 * kGap_px, kCaption_px),
                   Qt::AlignHCenter | Qt::AlignTop | Qt::TextDontClip, caption);
}

void SectionStrip::drawOutline(QPainter& painter, const VesselOutline& outline, const QRectF& cell) const {
  QPolygonF polygon;
  for (int ray = 0; ray < VesselOutline::kRays; ++ray) polygon << placeOf(outline, ray, cell);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(ui::toQColor(views::theme::kCaution), 1.5));
  painter.drawPolygon(polygon);
  painter.setBrush(ui::toQColor(views::theme::kCaution));
  painter.setPen(QPen(Qt::black, 1));
  const double around_px = 2 * std::sqrt(std::numbers::pi * outline.area_mm2()) * cell.width() / width_mm_;
  int every = 3;
  while (every < 9 && around_px * every / VesselOutline::kRays < kBetweenHandles_px) every += 3;
  for (int ray = 0; ray < VesselOutline::kRays; ray += every) painter.drawEllipse(polygon[ray], 3, 3);
}

void SectionStrip::drawSides(QPainter& painter, const QRectF& cell) const {
  const VesselFrame frame = vessel_.course()->frames()[vessel_.frame()];
  const QRectF inside = cell.adjusted(3, 1, -3, -1);
  const auto write = [&](int where, Vec3 direction) {
    const QString word = ui::qt(views::patientSide(direction));
    painter.setPen(Qt::black);
    painter.drawText(inside.translated(1, 1), where, word);
    painter.setPen(ui::toQColor(views::theme::kText));
    painter.drawText(inside, where, word);
  };
  write(Qt::AlignLeft | Qt::AlignVCenter, -frame.right);
  write(Qt::AlignRight | Qt::AlignVCenter, frame.right);
  write(Qt::AlignHCenter | Qt::AlignTop, -frame.down);
  write(Qt::AlignHCenter | Qt::AlignBottom, frame.down);
}

double SectionStrip::distance_mm(QPointF at) const {
  const QRectF cell = cellOf(kMiddle);
  const QPointF off = at - cell.center();
  return std::hypot(off.x(), off.y()) * width_mm_ / cell.width();
}

std::optional<int> SectionStrip::rayAt(QPointF at) const {
  if (!vessel_.course()) return std::nullopt;
  const QRectF cell = cellOf(kMiddle);
  if (!cell.contains(at)) return std::nullopt;
  const QPointF off = at - cell.center();
  const double turns = std::atan2(off.y(), off.x()) / (2 * std::numbers::pi) + 1;
  const int ray = int(std::lround(turns * VesselOutline::kRays)) % VesselOutline::kRays;
  const double beside_mm = std::abs(distance_mm(at) - vessel_.outline().radius_mm[std::size_t(ray)]);
  if (beside_mm * cell.width() / width_mm_ > kReach_px) return std::nullopt;
  return ray;
}

void SectionStrip::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !vessel_.course()) return;
  if (const auto ray = rayAt(event->localPos()); ray && vessel_.beginDrag()) {
    ray_ = ray;
    return;
  }
  for (int section = 0; section < kSections; ++section)
    if (const auto frame = frameOf(section); section != kMiddle && frame && cellOf(section).contains(event->localPos()))
      return vessel_.moveTo(*frame);
}

void SectionStrip::mouseMoveEvent(QMouseEvent* event) {
  if (ray_) return vessel_.drag(*ray_, distance_mm(event->localPos()));
  setCursor(rayAt(event->localPos()) ? Qt::PointingHandCursor : Qt::ArrowCursor);
}

void SectionStrip::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !ray_) return;
  ray_.reset();
  vessel_.endDrag();
}

}  // namespace insonate::prepare
