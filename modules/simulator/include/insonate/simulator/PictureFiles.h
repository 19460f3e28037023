#pragma once

#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/Frames.h>

#include <filesystem>
#include <string>

namespace insonate {

/// 8-bit grey PNG with its scale (pHYs). Written atomically; fails with a sentence.
Result<void> writePng(const BModeImage& image, const std::filesystem::path& file);

/// One look of a frame as NRRD: float32, samples fastest, then scanlines; linear amplitude before compounding, gain,
/// compression and scan conversion. Spacing is in mm along a scanline, and in mm (linear) or degrees (fan) across.
/// Written atomically; fails with a sentence.
Result<void> writeEnvelope(const EnvelopeFrame& envelope, const Probe& probe, const ImagingSettings& settings,
                           const std::filesystem::path& file, int look = 0);

}  // namespace insonate
