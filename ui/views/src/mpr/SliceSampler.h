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

/// Color and opacities of a label over the CT. A label with opacity 0 is not drawn.
struct LabelPaint {
  Color color;
  double fill = 0, outline = 0;  ///< opacities, 0 to 1
};

/// Samples CT and labels on a plane: the CT by trilinear interpolation in patient space, for any spacing and direction
/// of the grid; the label of the nearest voxel, with outlines at the borders between labels. Black outside the grid.
/// Keeps its buffers between calls.
class SliceSampler {
 public:
  void setWindowLevel(const WindowLevel& value);
  /// Sets the outlines' width in pixels, at least 1. Where two labels adjoin, half of the line lies in each of them.
  void setOutlineWidth(int width_px) { outline_px_ = width_px; }
  void setPaint(std::uint8_t label, const LabelPaint& paint) { paint_[label] = paint; }

  /// Sets the labels that a tool proposes in a block of the grid (255: no change). They are drawn over the other
  /// labels, in their own colors. Null: no proposal.
  void setProposal(const VoxelBox& box, const LabelMap* labels) { proposalBox_ = box, proposal_ = labels; }

  /// Range of display rows, counted from the top; `end` is one after the last.
  struct Rows {
    int first = 0, end = 0;
  };
  /// Returns the rows that a change of these voxels can affect, including outlines.
  Rows rowsOf(const VolumeGeometry& grid, const VoxelBox& edited, const SlicePlane& plane) const;

  /// Fills these rows of width * height * 3 bytes, top row first. The other rows must contain the result of the last
  /// call for the same plane. Uses TBB.
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
  std::vector<std::uint8_t> grayOfHu_;  ///< gray value for every int16
  std::uint8_t proposedAt(int i, int j, int k) const;

  AlignedColumns columns_;
  VoxelBox proposalBox_;
  const LabelMap* proposal_ = nullptr;
  std::vector<std::uint8_t> rowLabels_, rowProposed_;
  int outline_px_ = 1;
  WindowLevel windowLevel_{0, 0};
};

}  // namespace insonate::views
