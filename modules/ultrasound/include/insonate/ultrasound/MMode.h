#pragma once

#include <insonate/ultrasound/Frames.h>
#include <insonate/ultrasound/ImagingSettings.h>

#include <cstdint>
#include <span>

namespace insonate {

/// Samples an image along one scanline, for M-mode: a column of gray values at equal distances from the face (first) to
/// the depth of the image (last), interpolated between pixels; 0 outside the image. `across` is the scanline as a
/// fraction of the field of view from its left edge. `image` is the image of these settings.
void lineOverTime(const BModeImage& image, const Probe& probe, const ImagingSettings& settings, double across,
                  std::span<std::uint8_t> gray);

}  // namespace insonate
