#pragma once

#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/Frames.h>

namespace insonate::display {

/// Sets size and scale of the image: square pixels, centered, with the whole field of view as large as possible. No
/// gray values.
BModeImage pictureLayout(const BeamGrid& grid, const ImagingSettings& settings);

}  // namespace insonate::display
