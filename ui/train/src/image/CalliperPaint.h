#pragma once

#include <insonate/ultrasound/Frames.h>
#include <insonate/views/Calliper.h>

#include <QPainter>
#include <QPoint>
#include <span>

namespace insonate::train {

/// Callipers and their numbers over an image whose first pixel is at `origin`, as they are seen over the live one;
/// `letter` is the height of letters in pixels.
void paintCallipers(QPainter& painter, const BModeImage& image, QPoint origin,
                    std::span<const views::Calliper> callipers, int letter);

/// Paints the measured values, a line each, "1  12.3 mm", from `top` down.
void paintMeasures(QPainter& painter, QPoint top, std::span<const views::Calliper> callipers, int letter);
int measuresHeight(std::size_t callipers, int letter);

}  // namespace insonate::train
