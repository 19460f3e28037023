#pragma once

#include <gdcmFile.h>
#include <gdcmPixelFormat.h>

#include <array>
#include <optional>
#include <vector>

namespace insonate {

/// The stored pixels of a file, decompressed; none unless all are there. `size` is columns, rows, frames; of one sample
/// a pixel. Not by GDCM's ImageReader: it knows no label maps, and it ends the program on curves, overlays, icons and
/// representations that it does not expect.
std::optional<std::vector<char>> storedPixels(const gdcm::File& file, const std::array<unsigned, 3>& size,
                                              const gdcm::PixelFormat& format);

}  // namespace insonate
