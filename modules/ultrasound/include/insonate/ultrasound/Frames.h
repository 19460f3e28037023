#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace insonate {

/// Linear echo amplitudes on the beam grid, before compounding, gain, compression and scan conversion. Amplitude 1 is
/// the RMS amplitude of fully developed speckle in a tissue of 0 dB without attenuation. A frame consists of one or
/// more looks: renderings with independent speckle, which the display averages. Amplitudes of neighboring scanlines are
/// adjacent in memory.
struct EnvelopeFrame {
  int scanlines = 0, samples = 0, looks = 0;
  std::vector<float> amplitude;  ///< echo amplitudes, index [look][sample][scanline]

  void resize(int newScanlines, int newSamples, int newLooks) {
    scanlines = newScanlines, samples = newSamples, looks = newLooks;
    amplitude.resize(std::size_t(scanlines) * samples * looks);
  }
  float* look(int l) { return amplitude.data() + std::size_t(l) * scanlines * samples; }
  const float* look(int l) const { return amplitude.data() + std::size_t(l) * scanlines * samples; }
};

/// The displayed image: 8-bit gray, rows from the face down, black outside the field of view.
struct BModeImage {
  int width = 0, height = 0;
  double pixel_mm = 0;             ///< side of a pixel; pixels are square
  double left_mm = 0, top_mm = 0;  ///< lateral and axial position of the center of pixel (0, 0)
  std::vector<std::uint8_t> gray;  ///< gray values, index [row][column]
};

}  // namespace insonate
