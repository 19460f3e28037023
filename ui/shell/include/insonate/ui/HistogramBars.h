#pragma once

#include <insonate/views/HuHistogram.h>

#include <QRectF>
#include <functional>

class QPainter;

namespace insonate::ui {

/// A histogram's bars on a logarithmic scale, so that rare tissue is seen beside air. `placeOf` gives the x of a
/// Hounsfield unit. Nothing for an empty histogram.
void paintBars(QPainter& painter, const views::HuHistogram& histogram, const QRectF& area,
               const std::function<double(double hu)>& placeOf);

}  // namespace insonate::ui
