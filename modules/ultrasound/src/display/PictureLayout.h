#pragma once

#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/Frames.h>

namespace insonate::display {

/// Returns an image with size and scale, but without gray values: square pixels, centered, with the whole field of view
/// as large as possible.
BModeImage pictureLayout(const BeamGrid& grid, const ImagingSettings& settings);

}  // namespace insonate::display
