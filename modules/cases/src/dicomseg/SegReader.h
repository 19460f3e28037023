#pragma once

#include <insonate/cases/LabelFile.h>
#include <insonate/core/Progress.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace insonate {

/// Name of the algorithm in segments of this program.
inline constexpr const char* kAlgorithm = "Insonate";

/// A DICOM segmentation as it is stored: frames of one size in any order, each a slice of one segment, or of all where
/// the segmentation is a label map.
struct DicomSegments {
  struct Frame {
    Vec3 position_mm;        ///< center of its first pixel, patient LPS
    std::uint8_t label = 0;  ///< in this program's numbers; that of a label map is in its pixels
    std::size_t first = 0;   ///< its first pixel among all
  };
  std::vector<Frame> frames;  ///< by segment, as the file numbers them
  int columns = 0, rows = 0;
  std::array<Vec3, 2> direction;       ///< of i and j, unit, at right angles
  std::array<double, 2> spacing_mm{};  ///< along i, along j
  double step_mm = 0;                  ///< distance of neighboring slices
  std::vector<std::uint8_t> pixels;    ///< a bit each, the first in the lowest bit, or a byte each
  bool isLabelMap = false;             ///< bytes are labels, in this program's numbers
  int threshold = 0;                   ///< 0 for bits; of fractions, bytes from here on are inside

  std::string seriesUid;  ///< of the CT it was drawn on, where it says so; identifies, and must not be kept
  std::vector<std::string> notes;
  LabelColours colours;
  OwnLabels own;
  std::set<std::uint8_t> foreign;  ///< of these, whose names another program's user wrote

  /// Label of a pixel, counted from the frame's first; 0 if no segment is there.
  std::uint8_t labelAt(const Frame& frame, std::size_t pixel) const {
    const std::size_t at = frame.first + pixel;
    if (isLabelMap) return pixels[at];
    const bool inside = threshold > 0 ? pixels[at] >= threshold : (pixels[at / 8] >> (at % 8) & 1) != 0;
    return inside ? frame.label : std::uint8_t{0};
  }
};

/// Fails on files that are cut off, hold fewer pixels than they say, name segments or places that are not there, or lie
/// in more than one orientation.
Result<DicomSegments> readDicomSegments(const std::filesystem::path& file);

/// Each voxel of `grid` takes the pixel that it lies in; later segments win. Fails where nothing lands in the grid, and
/// when cancelled.
Result<LabelReadResult> placeSegments(const DicomSegments& segments, const VolumeGeometry& grid,
                                      const Progress& progress);

}  // namespace insonate
