#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>
#include <insonate/surface/Mesh.h>

#include <cstdint>
#include <vector>

namespace insonate {

struct SurfaceOptions {
  /// Minimum wavelength of details that smoothing keeps, 0 to 100. Shorter waves along the surface (noise, stair-steps
  /// of the grid) are removed; 0: no smoothing. The wavelength used is at least six voxels along the grid's coarsest
  /// axis (six blocks if detail_mm combines voxels). The surface stays within a voxel of the surface of the labeled
  /// region. After smoothing, the surface is moved by at most a quarter of a voxel, so that it encloses the volume of
  /// the labeled voxels.
  double smoothing_mm = 8;
  /// Maximum edge length of the blocks into which voxels are combined, so that large structures get fewer triangles; 0
  /// to 100; 0: voxels are not combined. Smaller blocks are used if the blocks would change the volume of the structure
  /// by more than a tenth, as for walls and nerves that are thinner than a block.
  double detail_mm = 1;
};

/// Returns the labels that occur in a label map, in ascending order, without background (0).
std::vector<std::uint8_t> structuresIn(const LabelMap& labels);

/// Extracts the surface of all voxels with this label, in patient LPS, from any grid (oblique, anisotropic, of either
/// handedness). The surface is closed, also at the border of the volume. The mesh includes the surfaces of separate
/// parts and of cavities. Voxels that meet only at an edge or corner are not joined. Memory and time grow with the
/// structure's bounding box. The same input gives the same mesh on any number of threads. Fails on label 0, a label
/// without voxels, an invalid grid or options, too little memory, and when cancelled.
Result<Mesh> extractSurface(const LabelMap& labels, std::uint8_t label, const SurfaceOptions& options = {},
                            const Progress& progress = {});

/// Extracts the surface of all labeled voxels together: the surface of the body. The surface is smooth even if the
/// skin's label is thinner than a voxel or has gaps between slices.
Result<Mesh> extractBody(const LabelMap& labels, const SurfaceOptions& options = {}, const Progress& progress = {});

}  // namespace insonate
