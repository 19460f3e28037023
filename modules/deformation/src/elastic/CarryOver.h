#pragma once

#include "elastic/Solver.h"

#include <insonate/core/Transform.h>

#include <vector>

namespace insonate::elastic {

/// Carries a solution over to a moved probe: each node looks up the place of its tissue in an earlier mesh. Tissue
/// that has left the plane counts as if it were in it.
class CarryOver {
 public:
  /// Mesh and solution as they are now.
  void keep(const Mesh& mesh, const Solver& solver);

  bool fits(const Mesh& mesh) const { return mesh.columns() == mesh_.columns() && mesh.rows() == mesh_.rows(); }
  /// Carries the stress to a mesh of the same size.
  void giveStress(const Mesh& mesh, const Materials& materials, const Transform& keptFromNow,
                  Prestress& prestress) const;
  void shareSolution(const Mesh& mesh, const Materials& materials, const Transform& keptFromNow, Solver& solver) const;

 private:
  Mesh::Place placeOf(const Mesh& mesh, std::size_t node, const Transform& keptFromNow) const;
  /// The cell that the middle of a cell was in, where `place` is that of its first corner; or a neighbor, if that is
  /// more like what the cell is made of now: a wall's stress in soft tissue beside it would make that buckle.
  std::size_t cellOf(const Mesh::Place& place, float mu) const;

  Mesh mesh_;
  Nodes at_;
  std::vector<float> pressure_, mu_;
  Prestress prestress_;
};

}  // namespace insonate::elastic
