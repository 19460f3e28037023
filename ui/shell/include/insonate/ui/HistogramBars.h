#pragma once

#include <insonate/views/HuHistogram.h>

#include <QRectF>
#include <functional>

class QPainter;

namespace insonate::ui {

/// Paints a histogram's bars on a logarithmic scale, so that rare tissue is visible beside air. `placeOf` gives the x
/// position of a Hounsfield value. Paints nothing for an empty histogram.
void paintBars(QPainter& painter, const views::HuHistogram& histogram, const QRectF& area,
               const std::function<double(double hu)>& placeOf);

}  // namespace insonate::ui
