#pragma once

#include <insonate/views/HuHistogram.h>

#include <QRectF>
#include <functional>

class QPainter;

namespace insonate::ui {

/// Paints the bars of a histogram on a logarithmic scale, on which rare tissue is visible beside air. `placeOf` returns
/// the x position of a Hounsfield value. Paints nothing for an empty histogram.
void paintBars(QPainter& painter, const views::HuHistogram& histogram, const QRectF& area,
               const std::function<double(double hu)>& placeOf);

}  // namespace insonate::ui
