#pragma once

#include <insonate/ultrasound/Frames.h>

#include <QImage>

namespace insonate::train {

/// The picture as it is kept: at its own resolution, with its depth scale in mm on the left, the probe's marker above,
/// and its size on paper (pHYs of a PNG). Fit for any thread.
QImage scaledPicture(const BModeImage& image);

/// Where the picture itself begins in it, in pixels.
QPoint pictureOrigin(const BModeImage& image);

}  // namespace insonate::train
