#pragma once

#include <insonate/segmentation/StraightenedVessel.h>

#include <QImage>

namespace insonate::prepare {

struct PrepareModel;

/// Returns a resampled image as the slices show it: with their window and level, and with their labels in the style and
/// opacity of the slices. Pixels without a CT value are black.
QImage drawnAsSlice(const ResampledImage& image, const PrepareModel& shared);

}  // namespace insonate::prepare
