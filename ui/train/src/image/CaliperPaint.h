#pragma once

#include <insonate/ultrasound/Frames.h>
#include <insonate/views/Caliper.h>

#include <QPainter>
#include <QPoint>
#include <span>

namespace insonate::train {

/// Paints calipers and their numbers over an image whose first pixel is at `origin`. They look the same as over the
/// live image. `letter`: height of the letters in pixels.
void paintCalipers(QPainter& painter, const BModeImage& image, QPoint origin, std::span<const views::Caliper> calipers,
                   int letter);

/// Paints the measured values downward from `top`, one per line: "1  12.3 mm".
void paintMeasures(QPainter& painter, QPoint top, std::span<const views::Caliper> calipers, int letter);
int measuresHeight(std::size_t calipers, int letter);

}  // namespace insonate::train
