#pragma once

#include "elastic/Mesh.h"

#include <insonate/image/PlaneDisplacement.h>

namespace insonate::elastic {

/// A mesh that has moved, seen backwards: a lattice of `step_mm` over the part of the plane within `half_mm` of the
/// axis and from `top_mm` to `bottom_mm`. One-to-one: single points that sharp
/// folds would turn over are moved between their neighbours.
struct InverseMapExtent {
  float half_mm = 30, top_mm = -5, bottom_mm = 50, step_mm = 0.5f;
};
/// `folded` is a buffer. False where a mesh is turned over so widely that the displacement is not one-to-one.
bool invertMesh(const Mesh& mesh, const Nodes& now, const InverseMapExtent& extent, std::vector<int>& folded,
                PlaneDisplacement& displacement);

}  // namespace insonate::elastic
