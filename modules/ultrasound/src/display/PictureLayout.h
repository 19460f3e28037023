#pragma once

#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/Frames.h>

namespace insonate::display {

/// Size and scale of the image: square pixels, the whole field of view as large as fits, centred. No gray values.
BModeImage pictureLayout(const BeamGrid& grid, const ImagingSettings& settings);

}  // namespace insonate::display
