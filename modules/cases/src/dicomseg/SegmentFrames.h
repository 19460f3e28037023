#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <cstdint>
#include <vector>

namespace insonate {

/// One slice of one structure.
struct SegmentFrame {
  int segment = 0;  ///< index of the structure's label in SegmentFrames::labels
  int k = 0;
};

/// A label map as DICOM stores it: one bit per voxel, frame after frame without gaps (PS3.5 8.1.1), the first pixel in
/// the lowest bit.
struct SegmentFrames {
  std::vector<std::uint8_t> labels;  ///< labels that occur in the map, ascending
  std::vector<SegmentFrame> frames;  ///< slices in which a structure occurs, ordered by structure, then by k
  std::vector<std::uint8_t> bits;
};

/// Converts a label map to frames; fails only when cancelled.
Result<SegmentFrames> framesOfLabels(const LabelMap& labels, const Progress& progress);

}  // namespace insonate
