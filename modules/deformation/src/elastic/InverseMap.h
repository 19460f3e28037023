#pragma once

#include "elastic/Mesh.h"

#include <insonate/image/PlaneDisplacement.h>

namespace insonate::elastic {

/// Extent of the lattice on which invertMesh() computes the displacement: |x| up to `half_mm`, z from `top_mm` to
/// `bottom_mm`, spacing `step_mm`. The spacing is finer than that of the mesh, since a collapsed lumen lies between two
/// rows of the lattice: with a coarser lattice, the lumen in the image would follow the lattice in visible steps.
struct InverseMapExtent {
  float half_mm = 30, top_mm = -5, bottom_mm = 50, step_mm = 0.25f;
};
/// Computes the inverse displacement of a mesh whose nodes have moved to the positions `now`, at each point of a
/// lattice. The displacement is made one-to-one: single lattice points at which a sharp fold would turn cells over are
/// moved between their neighbors. Returns false if larger parts of the mesh are turned over, so that the displacement
/// is not one-to-one. `folded` is a buffer.
bool invertMesh(const Mesh& mesh, const Nodes& now, const InverseMapExtent& extent, std::vector<int>& folded,
                PlaneDisplacement& displacement);

}  // namespace insonate::elastic
