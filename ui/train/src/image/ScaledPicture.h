#pragma once

#include <insonate/simulator/LiveImaging.h>
#include <insonate/views/Caliper.h>

#include <QImage>
#include <QSize>
#include <cstddef>
#include <span>

namespace insonate::train {

/// Returns the image in the form in which it is saved: at its own resolution, with a depth scale in mm at the left edge
/// of the field of view, the probe's marker above, and its physical size (pHYs of a PNG). Calipers are drawn over the
/// image, and their values are listed below it. May be called on any thread.
QImage scaledPicture(const LiveFrame& frame, std::span<const views::Caliper> calipers = {});

/// Returns the size, in pixels, of scaledPicture() with this number of calipers.
QSize scaledPictureSize(const BModeImage& image, std::size_t calipers);

/// Returns the position, in pixels, of the image within scaledPicture().
QPoint pictureOrigin(const BModeImage& image);

}  // namespace insonate::train
