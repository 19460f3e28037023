#include "PlanePlot.h"

#include "../attempt/ReplayReader.h"

#include <insonate/teaching/NeedlePath.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/Text.h>
#include <insonate/views/LabelColors.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace insonate::review {
namespace {

constexpr double kPixel_mm = 0.2, kTick_mm = 10;
constexpr int kVessel = 150, kOther = 90;  // opacity, of 255

QRgb shadeOf(std::uint8_t label) {
  if (label == 0) return 0;
  const bool vessel = label == kVein || label == kArtery;
  const views::Color c = views::labelColor(label, views::ColorScheme::Default);
  return qRgba(c.red, c.green, c.blue, vessel ? kVessel : kOther);
}

QImage imageOf(const SectionLabels& structures) {
  QImage image(structures.columns, structures.rows, QImage::Format_ARGB32);
  for (int row = 0; row < structures.rows; ++row) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
    for (int column = 0; column < structures.columns; ++column) line[column] = shadeOf(structures.at(column, row));
  }
  return image;
}

/// In pixels, centered, with one scale.
QRectF fitted(const QRectF& room, const QRectF& place_mm) {
  const double scale = std::min(room.width() / place_mm.width(), room.height() / place_mm.height());
  const QSizeF size = place_mm.size() * scale;
  return {room.center() - QPointF(size.width() / 2, size.height() / 2), size};
}

void paintScale(QPainter& painter, const QRectF& inner, const QRectF& place_mm, const ui::Ink& ink) {
  const double scale = inner.width() / place_mm.width();
  const double text = painter.fontMetrics().height();
  for (double mm = std::ceil(place_mm.top() / kTick_mm) * kTick_mm; mm <= place_mm.bottom(); mm += kTick_mm) {
    const double y = inner.top() + (mm - place_mm.top()) * scale;
    painter.setPen(QPen(ink.line, mm == 0 ? 1.4 : 0.6));
    painter.drawLine(QPointF(inner.left(), y), QPointF(inner.right(), y));
    painter.setPen(ink.quiet);
    painter.drawText(QRectF(inner.left() - 3 * text, y - text / 2, 3 * text - 5, text),
                     Qt::AlignRight | Qt::AlignVCenter, QString::number(mm));
  }
  for (double mm = std::ceil(place_mm.left() / kTick_mm) * kTick_mm; mm <= place_mm.right(); mm += kTick_mm) {
    const double x = inner.left() + (mm - place_mm.left()) * scale;
    painter.setPen(QPen(ink.line, 0.6));
    painter.drawLine(QPointF(x, inner.top()), QPointF(x, inner.bottom()));
    painter.setPen(ink.quiet);
    painter.drawText(QRectF(x - 20, inner.bottom() + 1, 40, text), Qt::AlignHCenter | Qt::AlignTop,
                     QString::number(mm));
  }
}

QColor inkOf(NeedlePlace place, const ui::Ink& ink) {
  return place == NeedlePlace::Vein         ? ink.good
         : place == NeedlePlace::WrongPlace ? ink.danger
         : place == NeedlePlace::Used       ? ink.caution
                                            : ink.text;
}

/// The sign of AttemptWords.h where the needle's place changes, since some users cannot tell the path's colors apart.
void paintPlaceSign(QPainter& painter, QPointF middle, NeedlePlace place, const ui::Ink& ink) {
  if (place == NeedlePlace::Clean || place == NeedlePlace::UnderSkin) return;
  QRectF room(QPointF(), QSizeF(2, 2) * painter.fontMetrics().height());
  room.moveCenter(middle);
  painter.setPen(inkOf(place, ink));
  painter.drawText(room, Qt::AlignCenter, ui::displayText(place).sign);
}

}  // namespace

PlaneSection sectionOf(const AttemptDigest& attempt, const PatientCase* patient) {
  PlaneSection section;
  const TrackPoint* point = sectionPoint(attempt.track);
  if (!point) return section;
  section.time_us = point->time_us;
  const auto sample = ReplayReader(attempt.recording).at(point->time_us);
  const PlaneArea area =
      sectionArea(attempt.track, attempt.recording->header().picture, sample ? sample->imageDepth_mm : 0);
  section.place_mm = QRectF(QPointF(area.left, area.top), QPointF(area.right, area.bottom));
  if (patient && sample && sample->patientFromProbe)
    section.structures = imageOf(sectionLabels(*patient, *sample->patientFromProbe, area, kPixel_mm));
  return section;
}

void paintPlane(QPainter& painter, const QRectF& place, const AttemptDigest& attempt, const PlaneSection& section,
                const ui::Ink& ink) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  if (section.place_mm.isEmpty()) {
    painter.setPen(ink.quiet);
    painter.drawText(place, Qt::AlignCenter | Qt::TextWordWrap,
                     tr("No path to show: the needle was never under the skin while a hand held the probe."));
    return painter.restore();
  }
  const double text = painter.fontMetrics().height();
  const QRectF inner = fitted(place.adjusted(3 * text, 4, -8, -text - 2), section.place_mm);
  paintScale(painter, inner, section.place_mm, ink);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  if (!section.structures.isNull()) painter.drawImage(inner, section.structures);
  const double scale = inner.width() / section.place_mm.width();
  const auto at = [&](const Vec3& tip_probe) {
    return inner.topLeft() +
           QPointF(tip_probe.x - section.place_mm.left(), tip_probe.z - section.place_mm.top()) * scale;
  };
  painter.setClipRect(inner);
  auto before = NeedlePlace::Clean;
  for (const PathPiece& piece : pathPieces(attempt.track, attempt.recording->header().picture)) {
    QPolygonF line;
    for (const PathPiece::Point& point : piece.points) line << at(point.tip_probe);
    painter.setPen(
        QPen(inkOf(piece.place, ink), piece.isInSlice ? 2.4 : 1.4, piece.isInSlice ? Qt::SolidLine : Qt::DotLine));
    painter.drawPolyline(line);
    if (piece.place != std::exchange(before, piece.place)) paintPlaceSign(painter, line.first(), piece.place, ink);
  }
  painter.restore();
}

}  // namespace insonate::review
