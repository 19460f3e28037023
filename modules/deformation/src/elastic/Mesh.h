#pragma once

#include "elastic/Elements.h"

#include <insonate/deformation/DeformationModel.h>

#include <vector>

namespace insonate::elastic {

/// Division of one axis of the mesh into blocks of about a millimeter; blocks marked as fine have small cells.
struct FineBlocks {
  std::vector<char> fine;
  float first_mm = 0, size_mm = 1;

  void mark(float from_mm, float to_mm);
  /// Tells whether these blocks contain all fine blocks of `needed` and not far too many others. `needed` may end
  /// earlier.
  bool serves(const FineBlocks& needed) const;
  float end_mm() const { return first_mm + size_mm * float(fine.size()); }
};

/// Grid lines of a mesh: columns along x, rows by depth below the skin. The cell size is mesh_mm near vessels, skin and
/// the ends of the face, twice that between them, and grows beyond.
struct MeshLines {
  std::vector<float> x_mm, depth_mm;
  FineBlocks across, down;
};

/// A mesh of four-node cells whose top row follows the skin. Nodes close to the outline of a vessel or a bone are moved
/// onto the outline.
class Mesh {
 public:
  static constexpr float kBeyond_mm = 70;   ///< distance by which the mesh extends beyond each end of the face
  static constexpr float kMaxSkin_mm = 25;  ///< maximum distance from the face at which skin is searched for

  /// Builds the mesh; allocates only if it is larger than every earlier mesh.
  void build(const TissuePlane& plane, const ProbeFace& face, const DeformationSettings& settings);

  int columns() const { return static_cast<int>(lines_.x_mm.size()); }
  int rows() const { return static_cast<int>(lines_.depth_mm.size()); }
  const MeshLines& lines() const { return lines_; }
  const Nodes& rest() const { return rest_; }
  const std::vector<PlaneTissue>& tissue() const { return tissue_; }  ///< tissue at each node
  /// Tissue at the middle of each cell, indexed by the cell's first node.
  const std::vector<PlaneTissue>& middle() const { return middle_; }
  const std::vector<float>& skin_mm() const { return skin_; }  ///< depth z of the skin in each column, probe frame

  /// Copies lines, skin and rest positions, without the tissue.
  void takeShape(const Mesh& other);

  /// Continuous column and row of a point, limited to the mesh. Nodes that were moved onto an outline count at their
  /// original positions. placeOf() is fastest if the point is near the node `guess`.
  struct Place {
    float column = 0, row = 0;
  };
  Place placeOf(float x_mm, float z_mm, std::size_t guess) const;

 private:
  void findNeed(const TissuePlane& plane, const ProbeFace& face, const DeformationSettings& settings);
  void chooseLines(const TissuePlane& plane, const ProbeFace& face, const DeformationSettings& settings);
  void findSkin(const TissuePlane& plane, const std::vector<float>& x_mm, std::vector<float>& skin_mm);
  void snap();
  void classifyCells(const TissuePlane& plane);

  MeshLines lines_;
  Nodes rest_;
  std::vector<PlaneTissue> tissue_, middle_;
  std::vector<float> skin_;
  struct {
    FineBlocks across, down;
  } needed_;
  std::vector<PlanePoint> points_;
  std::vector<float> aside_;
  struct Snapped {
    std::size_t node;
    float PlaneTissue::*outline;
  };
  std::vector<Snapped> snapped_;
};

}  // namespace insonate::elastic
