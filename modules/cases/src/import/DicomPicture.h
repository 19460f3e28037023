#pragma once

#include <gdcmFile.h>
#include <gdcmPixelFormat.h>

#include <array>
#include <optional>
#include <vector>

namespace insonate {

/// Returns the stored pixels of a file, decompressed; no value if pixels are missing. `size` is columns, rows, frames;
/// one sample per pixel. GDCM's ImageReader is not used: it does not read label maps, and it aborts the program on
/// unexpected curves, overlays, icons and representations.
std::optional<std::vector<char>> storedPixels(const gdcm::File& file, const std::array<unsigned, 3>& size,
                                              const gdcm::PixelFormat& format);

}  // namespace insonate
