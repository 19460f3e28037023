#pragma once

#include "elastic/Elements.h"

#include <insonate/deformation/DeformationModel.h>

#include <vector>

namespace insonate::elastic {

/// Blocks of about a millimeter of a line that have fine cells.
struct FineBlocks {
  std::vector<char> fine;
  float first_mm = 0, size_mm = 1;

  void mark(float from_mm, float to_mm);
  /// Tells whether these blocks suffice for the needed ones, which may end earlier, without being far too many.
  bool serves(const FineBlocks& needed) const;
  float end_mm() const { return first_mm + size_mm * float(fine.size()); }
};

/// Grid lines of a mesh: columns along x, rows by depth below the skin. Cells of mesh_mm near vessels, skin and the
/// ends of the face, twice that between, growing beyond.
struct MeshLines {
  std::vector<float> x_mm, depth_mm;
  FineBlocks across, down;
};

/// A mesh of four-node cells that follows the skin: its top row lies on it. Nodes next to the outline of a vessel or a
/// bone are moved onto it.
class Mesh {
 public:
  static constexpr float kBeyond_mm = 70;    ///< tissue that is meshed beyond the face, each way
  static constexpr float kMostSkin_mm = 25;  ///< skin further than this off the face is not looked for

  /// Allocates only for a mesh larger than those before.
  void build(const TissuePlane& plane, const ProbeFace& face, const DeformationSettings& settings);

  int columns() const { return static_cast<int>(lines_.x_mm.size()); }
  int rows() const { return static_cast<int>(lines_.depth_mm.size()); }
  const MeshLines& lines() const { return lines_; }
  const Nodes& rest() const { return rest_; }
  const std::vector<PlaneTissue>& tissue() const { return tissue_; }  ///< at each node
  const std::vector<PlaneTissue>& middle() const { return middle_; }  ///< of each cell, numbered as its first node
  const std::vector<float>& skin_mm() const { return skin_; }         ///< z of the top of each column

  /// Lines, skin and rest positions, without the tissue.
  void takeShape(const Mesh& other);

  /// Continuous column and row of a point, clamped to the mesh; as if no node had been moved onto an outline. Fast
  /// near the node `guess`.
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
