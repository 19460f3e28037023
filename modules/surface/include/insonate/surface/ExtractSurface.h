#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>
#include <insonate/surface/Mesh.h>

#include <cstdint>
#include <vector>

namespace insonate {

struct SurfaceOptions {
  /// Waves along the surface shorter than this, or than six voxels (blocks, where detail_mm makes them) along the
  /// grid's coarsest axis, are smoothed away: noise, and the stairs of the grid. 0 to 100; 0 for no smoothing. The
  /// surface stays within a voxel of the labeled one and, as far as moving it by a quarter of a voxel allows, encloses
  /// the volume of the labeled voxels.
  double smoothing_mm = 8;
  /// Voxels are put together, along each axis by itself, to blocks of at most this edge, so that large structures get
  /// fewer triangles; 0 to 100, at 0 every voxel counts. Where that would change the volume by more than a tenth (walls
  /// and nerves thinner than a block), smaller blocks are taken.
  double detail_mm = 1;
};

/// The structures of a label map, in ascending order, without the background (0).
std::vector<std::uint8_t> structuresIn(const LabelMap& labels);

/// The closed surface of all voxels with this label, in patient LPS on any grid (oblique, anisotropic, of either
/// handedness). It is closed at the border of the volume too; separate parts and cavities are parts of the mesh. Voxels
/// that meet only at an edge or corner are not joined. Memory and time go with the structure's bounding box. Same
/// input: same mesh, on any number of threads. Fails on label 0, a label that no voxel has, a grid or options that are
/// none, too little memory, and when cancelled.
Result<Mesh> extractSurface(const LabelMap& labels, std::uint8_t label, const SurfaceOptions& options = {},
                            const Progress& progress = {});

/// Extracts the surface of all labeled voxels together: the visible body, smooth also where the label of the skin is
/// thinner than a voxel or torn between slices.
Result<Mesh> extractBody(const LabelMap& labels, const SurfaceOptions& options = {}, const Progress& progress = {});

}  // namespace insonate
