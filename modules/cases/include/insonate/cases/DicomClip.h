#pragma once

#include <insonate/cases/DicomWriter.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace insonate {

/// Position and scale of the ultrasound image in each frame of a clip.
struct ClipRegion {
  int left_px = 0, top_px = 0, width_px = 0, height_px = 0;
  double pixel_mm = 0;  ///< side of a pixel; pixels are square
  /// lateral position and depth below the probe's face of the center of the region's first pixel (left, top)
  double left_mm = 0, top_mm = 0;
};

/// A clip of simulated ultrasound images, except its pixels.
struct DicomClip {
  DicomSeriesIdentity identity{};  ///< patient and study of the clip; its description is the end of Series Description
  std::string seed{};              ///< text from which the UIDs of series and instance are derived, with identity.seed
  int width = 0, height = 0;       ///< size of each frame in pixels, 1..65535
  int channels = 1;                ///< 1: gray (MONOCHROME2); 3: red, green, blue
  ClipRegion region{};
  std::vector<double> time_s{};  ///< time of each frame, ascending
};

/// Writes a clip as a DICOM Ultrasound Multi-frame Image (PS3.3 A.7, Part 10, explicit VR little endian, 8 bits, not
/// compressed). One ultrasound region states the scale in cm per pixel, so that viewers measure in mm. The frames have
/// the intervals of their times. Series Description and Derivation Description state that the images are simulated,
/// Image Type is DERIVED, and Synthetic Data is YES. `draw` makes the pixels of frame `index`, index
/// [row][column][channel]; it is called for 0 to time_s.size() - 1, on the calling thread. The file is written
/// atomically. Fails if `draw` fails, when cancelled, on a clip of no frames or of more than 4 GB, on pixels of another
/// size, on a region outside the frame, or if the file cannot be written.
Result<void> writeDicomClip(
    const DicomClip& clip, const std::filesystem::path& file,
    const std::function<Result<void>(std::size_t index, std::vector<std::uint8_t>& pixels)>& draw,
    const Progress& progress = {});

}  // namespace insonate
