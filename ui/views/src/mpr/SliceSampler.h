#pragma once

#include "AlignedColumns.h"

#include <insonate/image/VoxelBox.h>
#include <insonate/views/SlicePlane.h>
#include <insonate/views/Theme.h>
#include <insonate/views/WindowLevel.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace insonate::views {

/// Look of each label over the CT. Opacity 0 leaves it out.
struct LabelPaint {
  Colour colour;
  double fill = 0, outline = 0;  ///< opacities, 0..1
};

/// CT and labels on a plane: trilinear CT in patient space, for any spacing and direction of the grid, and the nearest
/// voxel's label, outlined where labels meet. Black outside the grid. Keeps its work space between calls.
class SliceSampler {
 public:
  void setWindowLevel(const WindowLevel& value);
  /// Sets the outlines' width in pixels, at least 1; half of a line between two labels lies in each.
  void setOutlineWidth(int width_px) { outline_px_ = width_px; }
  void setPaint(std::uint8_t label, const LabelPaint& paint) { paint_[label] = paint; }

  /// Sets labels that are proposed in a block of the grid, 255 for none; drawn over the others in their colors. Null
  /// without.
  void setProposal(const VoxelBox& box, const LabelMap* labels) { proposalBox_ = box, proposal_ = labels; }

  /// Rows of the display, from the top; the last one is not among them.
  struct Rows {
    int first = 0, end = 0;
  };
  /// Rows that edited voxels may have changed, outlines included.
  Rows rowsOf(const VolumeGeometry& grid, const VoxelBox& edited, const SlicePlane& plane) const;

  /// Fills these rows of width * height * 3 bytes, top row first; the others are as the last call left them, which must
  /// have been of the same plane. Uses TBB.
  void sample(const CtVolume& ct, const LabelMap& labels, const SlicePlane& plane, Rows rows,
              std::span<std::uint8_t> rgb);

 private:
  void sampleAlignedRow(const CtVolume& ct, const LabelMap& labels, const SlicePlane& plane, int row,
                        std::uint8_t* rgb);
  void sampleObliqueRow(const CtVolume& ct, const LabelMap& labels, const SlicePlane& plane, int row,
                        std::uint8_t* rgb);
  void paintRow(const SlicePlane& plane, int row, std::uint8_t* rgb) const;
  bool isEdge(const SlicePlane& plane, int row, int column) const;

  std::array<LabelPaint, 256> paint_{};
  std::vector<std::uint8_t> greyOfHu_;  ///< of every int16
  std::uint8_t proposedAt(int i, int j, int k) const;

  AlignedColumns columns_;
  VoxelBox proposalBox_;
  const LabelMap* proposal_ = nullptr;
  std::vector<std::uint8_t> rowLabels_, rowProposed_;
  int outline_px_ = 1;
  WindowLevel windowLevel_{0, 0};
};

}  // namespace insonate::views
