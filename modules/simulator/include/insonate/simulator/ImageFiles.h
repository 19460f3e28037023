#pragma once

#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/FovFit.h>
#include <insonate/ultrasound/Frames.h>

#include <filesystem>
#include <string>

namespace insonate {

/// Writes an ultrasound image as an 8-bit gray PNG with its scale in pixels per meter (pHYs). Written atomically; fails
/// with a sentence.
Result<void> writePng(const BModeImage& image, const std::filesystem::path& file);

/// Reads the gray values of a PNG or JPEG file, which is recognized by its first bytes; transparent parts are black.
/// Fails with a sentence on any other file, on a damaged file, and on more than 16384 pixels in either direction.
Result<GreyPicture> readGrayImage(const std::filesystem::path& file);

/// Writes an image as PNG with the fitted field of view drawn over it in color: its outline, and the marks of the depth
/// scale. Written atomically; fails with a sentence.
Result<void> writeFitImage(const GreyPicture& picture, const FovFit& fit, const std::filesystem::path& file);

/// Writes the envelope of a frame as NRRD, for one compounding angle (`look`, its index): float32, samples fastest,
/// then scanlines; linear amplitude before compounding, gain, compression and scan conversion. Spacing is in mm along a
/// scanline, and in mm (linear) or degrees (fan) between scanlines. Written atomically; fails with a sentence.
Result<void> writeEnvelope(const EnvelopeFrame& envelope, const Probe& probe, const ImagingSettings& settings,
                           const std::filesystem::path& file, int look = 0);

}  // namespace insonate
