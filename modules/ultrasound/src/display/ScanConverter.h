#pragma once

#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/Frames.h>

#include <cstdint>
#include <vector>

namespace insonate::display {

/// Converts gray values on the beam grid to the image, in two steps. First, a column halfway between each two scanlines
/// is computed by cubic interpolation: scanlines are far apart, and bilinear interpolation between them would lose
/// lateral detail. Second, each pixel is interpolated bilinearly, with tables that were made once. The image is black
/// outside the field of view.
class ScanConverter {
 public:
  ScanConverter(const Probe& probe, const ImagingSettings& settings);

  /// Returns the row for the gray values of one sample depth, one per scanline, with room for whole SIMD vectors.
  std::uint8_t* greyRow(int sample) { return grey_.data() + std::size_t(sample) * greyStride_ + kMargin; }
  /// Computes the image and sets its size and scale. Uses the calling thread's TBB arena.
  void convert(BModeImage& image);

 private:
  /// A run of pixels inside the field of view.
  struct Run {
    int column, count;
    std::size_t table;  ///< index of the run's first pixel in the tables
  };
  void refine(int sample);
  std::uint16_t* fineRow(int sample) { return fine_.data() + std::size_t(sample) * fineStride_; }
  const std::uint8_t* fineBytes(int sample) { return reinterpret_cast<const std::uint8_t*>(fineRow(sample)); }
  void addRow(const BeamGrid& grid, int row);
  void addPixel(const BeamGrid::Location& at);
  void convertRow(int row, std::uint8_t* out) const;

  static constexpr int kMargin = 16;  ///< number of extra columns on each side of a gray row

  int samples_, scanlines_, greyStride_;
  int columns_, fineStride_;  ///< size of a refined row (with columns halfway between scanlines): columns_ single
                              ///< columns, fineStride_ pairs
  BModeImage layout_;
  std::vector<std::uint8_t> grey_;
  std::vector<std::uint16_t> fine_;  ///< refined rows; each element holds two columns
  std::vector<std::uint32_t> packed_;
  std::vector<Run> runs_;
  std::vector<std::size_t> firstRun_;  ///< index of the first run of each image row, and the number of all runs
  std::vector<std::int32_t> index_;
  std::vector<std::uint16_t> weight_;
};

}  // namespace insonate::display
