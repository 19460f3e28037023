#pragma once

#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/Frames.h>

#include <cstdint>
#include <vector>

namespace insonate::display {

/// Grey values on the beam grid to the picture: bilinear from tables made once, black outside the field of view.
class ScanConverter {
 public:
  ScanConverter(const Probe& probe, const ImagingSettings& settings);

  /// Where the grey values of one sample go, one per scanline; room for whole vectors.
  std::uint8_t* greyRow(int sample) { return grey_.data() + std::size_t(sample) * rowStride_; }
  /// Uses the calling thread's TBB arena. Gives `image` its size and scale.
  void convert(BModeImage& image);

 private:
  /// A run of pixels inside the field of view.
  struct Run {
    int column, count;
    std::size_t table;  ///< of its first pixel
  };
  void addRow(const BeamGrid& grid, int row);
  void addPixel(const BeamGrid::Location& at);
  void convertRow(int row, std::uint8_t* out) const;

  int samples_, columns_, rowStride_, scanlines_;
  BModeImage layout_;
  std::vector<std::uint8_t> grey_;
  std::vector<std::uint32_t> packed_;
  std::vector<Run> runs_;
  std::vector<std::size_t> firstRun_;  ///< of each row, and the end
  std::vector<std::int32_t> index_;
  std::vector<std::uint16_t> weight_;
};

}  // namespace insonate::display
