#pragma once

#include <insonate/ultrasound/Frames.h>
#include <insonate/views/Calliper.h>

#include <QImage>
#include <span>

namespace insonate::train {

/// The image as it is kept: at its own resolution, with its depth scale in mm on the left, the probe's marker above,
/// and its size on paper (pHYs of a PNG). Callipers are drawn over it, and what they measure is listed below it. Fit
/// for any thread.
QImage scaledPicture(const BModeImage& image, std::span<const views::Calliper> callipers = {});

/// Position of the image itself in it, in pixels.
QPoint pictureOrigin(const BModeImage& image);

}  // namespace insonate::train
