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
  setToolTip(
      tr("Colours go from the novice's value to the expert's, as studies found them; the number is the mean of "
         "the last attempts"));
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
                   right + tr("      n/a: no attempt tells it      without a colour: nothing to compare with"));
}

}  // namespace insonate::review
