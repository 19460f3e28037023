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

/// Algorithm name in segments that this program writes.
inline constexpr const char* kAlgorithm = "Insonate";

/// A DICOM segmentation as it is stored: frames of one size in any order. Each frame is a slice of one segment; in a
/// label map, a slice of all segments. Contains only the segments that are read.
struct DicomSegments {
  struct Frame {
    Vec3 position_mm;  ///< center of the frame's first pixel, patient LPS
    /// Place of the frame's segment in `structures`, counted from 1; unused in a label map, whose pixels are places.
    std::uint8_t part = 0;
    std::size_t first = 0;  ///< index of the frame's first pixel in `pixels`
  };
  std::vector<Frame> frames;  ///< all frames, ordered by the file's segment numbers
  int columns = 0, rows = 0;
  std::array<Vec3, 2> direction;       ///< patient directions of the pixel indices i and j, unit, perpendicular
  std::array<double, 2> spacing_mm{};  ///< distance between pixels along i and along j
  double step_mm = 0;                  ///< distance between neighboring slices
  std::vector<std::uint8_t> pixels;    ///< pixels of all frames, one bit each (lowest bit first) or one byte each
  bool isLabelMap = false;             ///< true if pixels are places in `structures`, counted from 1
  /// 0 if pixels are bits; else the minimum value of a byte inside the segment (fractional segmentation).
  int threshold = 0;

  std::string seriesUid;  ///< UID of the CT series on which the segmentation was drawn, if stated; identifies the
                          ///< patient and must not be stored
  std::vector<std::string> notes;
  LabelColors colors;
  OwnLabels own;
  std::set<std::uint8_t> foreign;  ///< the author's own labels whose names were written by users of another program
  std::vector<ReadStructure> structures;

  /// Returns the place in `structures`, counted from 1, of a frame's pixel, which is counted from the frame's first
  /// pixel; 0 if no segment is there.
  std::uint8_t partAt(const Frame& frame, std::size_t pixel) const {
    const std::size_t at = frame.first + pixel;
    if (isLabelMap) return pixels[at];
    const bool inside = threshold > 0 ? pixels[at] >= threshold : (pixels[at / 8] >> (at % 8) & 1) != 0;
    return inside ? frame.part : std::uint8_t{0};
  }
};

/// Reads the taken segments of a segmentation file. Fails on files that are truncated, contain fewer pixels than
/// declared, refer to missing segments or positions, or have more than one orientation.
Result<DicomSegments> readDicomSegments(const std::filesystem::path& file, const StructureChoices& choices);

/// Gives each voxel of `grid` the label (and LabelReadResult::parts) of the pixel that contains it; later segments
/// replace earlier ones. Fails if no labeled pixel lies in the grid, and when cancelled.
Result<LabelReadResult> placeSegments(const DicomSegments& segments, const VolumeGeometry& grid,
                                      const Progress& progress);

}  // namespace insonate
