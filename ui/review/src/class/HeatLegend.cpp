#include "HeatLegend.h"

#include "HeatMap.h"

#include <insonate/ui/Theme.h>

#include <QPainter>

namespace insonate::review {
namespace {

constexpr int kBar_px = 160;

}  // namespace

HeatLegend::HeatLegend(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("heatLegend"));
  setToolTip(tr("Colors range from the novice's published value to the expert's; the number is the mean of the last %1 "
                "attempts at levels that count, without free practice")
                 .arg(kLastAttempts));
  setFixedHeight(fontMetrics().height() + ui::kSmallGap);
}

void HeatLegend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(ui::colour(views::theme::kQuiet));
  const QString left = tr("as a novice"), right = tr("as an expert");
  const int from = painter.fontMetrics().horizontalAdvance(left) + ui::kGap;
  painter.drawText(QRect(0, 0, from, height()), Qt::AlignVCenter, left);
  for (int x = 0; x < kBar_px; ++x)
    painter.fillRect(from + x, ui::kSmallGap, 1, height() - 2 * ui::kSmallGap, heatColour(100.0 * x / kBar_px));
  painter.setPen(ui::colour(views::theme::kQuiet));
  painter.drawText(QRect(from + kBar_px + ui::kGap, 0, width(), height()), Qt::AlignVCenter,
                   right + tr("      mean of the last %1 attempts, without free practice      n/a: no data      "
                              "without a color: no published values")
                               .arg(kLastAttempts));
}

}  // namespace insonate::review
