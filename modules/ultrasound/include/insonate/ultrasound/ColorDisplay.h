#pragma once

#include <insonate/ultrasound/ColorDoppler.h>
#include <insonate/ultrasound/Frames.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace insonate {

using Rgb = std::array<std::uint8_t, 3>;

/// Color to be drawn over a B-mode image: a rectangle of its pixels, with the gray outline of the color box.
struct ColorImage {
  int column = 0, row = 0;         ///< first pixel of the rectangle in the B-mode image
  int width = 0, height = 0;       ///< size of the rectangle; 0: no color
  std::vector<std::uint8_t> rgba;  ///< red, green, blue, and 255 where color is shown, else 0; [row][column][4]
  std::array<Rgb, 64> scale{};     ///< colors of the scale, from its lower end to its upper end
  double nyquist_mmps = 0;         ///< velocity at the ends of the color scale

  bool empty() const { return width == 0 || height == 0; }
};

/// Returns the color of a velocity, from -1 (Nyquist velocity away from the probe) to 1 (toward the probe).
Rgb velocityColor(double share, bool invert);
/// Returns the color of a power, from 0 (threshold) to 1 (30 dB above).
Rgb powerColor(double share);

/// Corners of the color box in the image plane, probe frame (x, 0, z), mm: near left, near right, far right, far left.
std::array<Vec3, 4> colorBoxCorners(const Probe& probe, const ImagingSettings& settings, const ColorSettings& color);

/// Converts a color frame to pixels: noise of the estimate from a packet of pulses > smoothing > persistence > scan
/// conversion > threshold > priority > color map. The constructor allocates everything; process() allocates nothing
/// once the image has its size. The settings must be valid. One object must not be used concurrently.
class ColorDisplay {
 public:
  ColorDisplay(const Probe& probe, const ImagingSettings& settings, const ColorSettings& color);
  ~ColorDisplay();
  ColorDisplay(ColorDisplay&&) noexcept;
  ColorDisplay& operator=(ColorDisplay&&) noexcept;

  /// Processes one frame. `gray` is the B-mode image of the same settings. The noise depends only on `noiseSeed`.
  void process(const ColorFrame& frame, const BModeImage& gray, ColorImage& image, std::uint32_t noiseSeed = 0);
  /// Discards the previous image, so that the next image has no persistence.
  void reset();

  /// Returns the estimate that process() computed last: velocity toward the probe at each gate, mm/s, [line][gate]; NaN
  /// where no color is shown.
  const std::vector<float>& velocities_mmps() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
