#pragma once

#include <insonate/cases/DicomClip.h>
#include <insonate/ultrasound/Frames.h>

namespace insonate {

/// Tells whether two images have the same size, scale and position below the probe, as the images of a DICOM clip must.
bool hasSameGrid(const BModeImage& a, const BModeImage& b);

/// Returns the region of a DICOM clip whose frames contain `image` with its first pixel at (`left_px`, `top_px`).
ClipRegion regionOf(const BModeImage& image, int left_px = 0, int top_px = 0);

}  // namespace insonate
