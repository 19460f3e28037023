#include "CaliperPaint.h"

#include <insonate/ui/Theme.h>

#include <QPolygonF>
#include <array>
#include <vector>

namespace insonate::train {
namespace {

/// Light on dark, so that it is read over any tissue.
class Pen {
 public:
  Pen(QPainter& painter, double width) : painter_(painter), width_(width) { painter_.setBrush(Qt::NoBrush); }

  template <class Draw>
  void stroke(const Draw& draw) {
    QColor under = ui::toQColor(views::theme::kBlack);
    under.setAlphaF(0.5);
    painter_.setPen(QPen(under, width_ + 2));
    draw();
    painter_.setPen(QPen(ui::toQColor(views::theme::kText), width_));
    draw();
  }
  void cross(QPointF at, double arm) {
    stroke([&] {
      painter_.drawLine(at - QPointF(arm, 0), at + QPointF(arm, 0));
      painter_.drawLine(at - QPointF(0, arm), at + QPointF(0, arm));
    });
  }
  void dotted(QPointF from, QPointF to) {
    painter_.setPen(QPen(ui::toQColor(views::theme::kText), 1.5 * width_, Qt::CustomDashLine, Qt::RoundCap));
    QPen pen = painter_.pen();
    pen.setDashPattern({0.01, 3});
    painter_.setPen(pen);
    painter_.drawLine(from, to);
  }

 private:
  QPainter& painter_;
  double width_;
};

QString numberOf(std::size_t k) {
  return QString::number(int(k) + 1);
}

}  // namespace

void paintCalipers(QPainter& painter, const BModeImage& image, QPoint origin, std::span<const views::Caliper> calipers,
                   int letter) {
  const auto pixel = [&](const views::ImagePoint& p) {
    // Half a pixel on: places are those of the pixels' middles.
    return QPointF(origin) + QPointF((p.lateral_mm - image.left_mm) / image.pixel_mm + 0.5,
                                     (p.axial_mm - image.top_mm) / image.pixel_mm + 0.5);
  };
  Pen pen(painter, letter / 10.0);
  for (std::size_t k = 0; k < calipers.size(); ++k) {
    const views::Caliper& caliper = calipers[k];
    const std::array<QPointF, 3> at{pixel(caliper.points[0]), pixel(caliper.points[1]), pixel(caliper.points[2])};
    const bool angle = caliper.kind == views::CaliperKind::Angle;
    if (caliper.kind == views::CaliperKind::Distance) pen.dotted(at[0], at[1]);
    if (angle) pen.stroke([&] { painter.drawPolyline(at.data(), 3); });
    QPolygonF ring;
    for (const views::ImagePoint& point : views::outline(caliper)) ring << pixel(point);
    if (!ring.isEmpty()) pen.stroke([&] { painter.drawPolygon(ring); });
    const int marks = angle ? 3 : 2;
    for (int m = 0; m < marks; ++m) pen.cross(at[m], 0.5 * letter);
    painter.setPen(ui::toQColor(views::theme::kText));
    painter.drawText(at[marks - 1] + QPointF(0.7 * letter, -0.3 * letter), numberOf(k));
  }
}

int measuresHeight(std::size_t calipers, int letter) {
  return int(calipers) * letter * 3 / 2;
}

void paintMeasures(QPainter& painter, QPoint top, std::span<const views::Caliper> calipers, int letter) {
  painter.setPen(ui::toQColor(views::theme::kText));
  for (std::size_t k = 0; k < calipers.size(); ++k)
    painter.drawText(top + QPoint(0, measuresHeight(k, letter) + letter),
                     numberOf(k) + QStringLiteral("  ") + QString::fromStdString(views::caliperText(calipers[k])));
}

}  // namespace insonate::train
