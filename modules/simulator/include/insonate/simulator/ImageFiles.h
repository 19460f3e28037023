#pragma once

#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/ColorDisplay.h>
#include <insonate/ultrasound/FovFit.h>
#include <insonate/ultrasound/Frames.h>

#include <filesystem>
#include <string>

namespace insonate {

/// Writes an ultrasound image as an 8-bit gray PNG with its scale in pixels per meter (pHYs). The file is written
/// atomically. Fails with a sentence.
Result<void> writePng(const BModeImage& image, const std::filesystem::path& file);

/// Writes an ultrasound image as PNG with color Doppler drawn over it, and with the scale of the colors beside the
/// upper right corner. Without color, the PNG is gray.
Result<void> writePng(const BModeImage& image, const ColorImage& color, const std::filesystem::path& file);

/// Reads the gray values of a PNG or JPEG file; the first bytes of the file determine the format. Transparent parts
/// become black. Fails with a sentence on any other file, on a damaged file, and on more than 16384 pixels in either
/// direction.
Result<GrayImage> readGrayImage(const std::filesystem::path& file);

/// Writes an image as PNG with the fitted field of view drawn over the image in color: the outline, and the marks of
/// the depth scale. The file is written atomically. Fails with a sentence.
Result<void> writeFitImage(const GrayImage& picture, const FovFit& fit, const std::filesystem::path& file);

/// Writes one look of the envelope of a frame (`look`: its index) as NRRD: float32, linear amplitude before
/// compounding, gain, compression and scan conversion. The first axis counts samples, the second axis scanlines.
/// Spacing is in mm along a scanline, and in mm (linear) or degrees (fan) between scanlines. The file is written
/// atomically. Fails with a sentence.
Result<void> writeEnvelope(const EnvelopeFrame& envelope, const Probe& probe, const ImagingSettings& settings,
                           const std::filesystem::path& file, int look = 0);

}  // namespace insonate
