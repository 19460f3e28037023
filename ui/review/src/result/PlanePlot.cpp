#include "PlanePlot.h"

#include "../attempt/ReplayReader.h"

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

constexpr double kPixel_mm = 0.2, kAside_mm = 3, kAbove_mm = 5, kTick_mm = 10;
constexpr int kVessel = 150, kOther = 90;  // opacity, of 255

/// Point at which the vein was reached, else the deepest point of the needle; among points with both hands.
const TrackPoint* cutAt(const AttemptDigest& attempt) {
  const TrackPoint* deepest = nullptr;
  for (const TrackPoint& point : attempt.track) {
    if (!point.needleDepth_mm || !point.tip_probe) continue;
    if (point.place == NeedlePlace::Vein) return &point;
    if (!deepest || *point.needleDepth_mm > *deepest->needleDepth_mm) deepest = &point;
  }
  return deepest;
}

QRgb shadeOf(std::uint8_t label) {
  const bool vessel = label == kVein || label == kArtery;
  if (!vessel && label != kBone && label != kAirway && label != kSkin) return 0;
  const views::Color c = views::labelColor(label, views::ColorScheme::Default);
  return qRgba(c.red, c.green, c.blue, vessel ? kVessel : kOther);
}

QImage structuresAt(const LabelMap& labels, const Transform& patientFromProbe, const QRectF& place_mm) {
  const Transform indexFromProbe = labels.geometry.indexFromPatient() * patientFromProbe;
  QImage image(int(place_mm.width() / kPixel_mm), int(place_mm.height() / kPixel_mm), QImage::Format_ARGB32);
  for (int row = 0; row < image.height(); ++row) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
    for (int column = 0; column < image.width(); ++column) {
      const Vec3 at_mm{place_mm.left() + (column + 0.5) * kPixel_mm, 0, place_mm.top() + (row + 0.5) * kPixel_mm};
      line[column] = shadeOf(sampleNearest(labels, indexFromProbe * at_mm));
    }
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

/// Piece of the tip's path drawn in one style.
struct Piece {
  NeedlePlace place;
  bool seen;  ///< within the image's slice
  std::vector<Vec3> tips_probe;
};

std::vector<Piece> piecesOf(const AttemptDigest& attempt) {
  const ImageField& field = attempt.recording->header().picture;
  std::vector<Piece> pieces;
  bool broken = true;
  for (const TrackPoint& point : attempt.track) {
    if (!point.needleDepth_mm || !point.tip_probe) {
      broken = true;
      continue;
    }
    const bool seen = std::abs(point.tip_probe->y) <= maxOffPlane_mm(field, point.tip_probe->z);
    if (broken || pieces.back().place != point.place || pieces.back().seen != seen) {
      // Pieces of one path share their end points.
      const auto join = broken ? std::vector<Vec3>{} : std::vector<Vec3>{pieces.back().tips_probe.back()};
      pieces.push_back({point.place, seen, join});
      broken = false;
    }
    pieces.back().tips_probe.push_back(*point.tip_probe);
  }
  return pieces;
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
  const TrackPoint* cut = cutAt(attempt);
  if (!cut) return section;
  section.time_us = cut->time_us;
  const auto sample = ReplayReader(attempt.recording).at(cut->time_us);
  const double half_mm = std::max(attempt.recording->header().picture.width_mm, 30.0) / 2;
  double left = -half_mm, right = half_mm, bottom = 20;
  for (const TrackPoint& point : attempt.track) {
    if (!point.needleDepth_mm || !point.tip_probe) continue;
    left = std::min(left, point.tip_probe->x - kAside_mm), right = std::max(right, point.tip_probe->x + kAside_mm);
    bottom = std::max(bottom, point.tip_probe->z + kAside_mm);
  }
  if (sample) bottom = std::max(bottom, sample->imageDepth_mm);
  section.place_mm = QRectF(QPointF(left, -kAbove_mm), QPointF(right, bottom));
  if (patient && sample && sample->patientFromProbe)
    section.structures = structuresAt(patient->labels, *sample->patientFromProbe, section.place_mm);
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
  for (const Piece& piece : piecesOf(attempt)) {
    QPolygonF line;
    for (const Vec3& tip : piece.tips_probe) line << at(tip);
    painter.setPen(QPen(inkOf(piece.place, ink), piece.seen ? 2.4 : 1.4, piece.seen ? Qt::SolidLine : Qt::DotLine));
    painter.drawPolyline(line);
    if (piece.place != std::exchange(before, piece.place)) paintPlaceSign(painter, line.first(), piece.place, ink);
  }
  painter.restore();
}

}  // namespace insonate::review
