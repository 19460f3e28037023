#pragma once

#include "elastic/Solver.h"

#include <insonate/core/Transform.h>

#include <vector>

namespace insonate::elastic {

/// Transfers a solution to a new mesh after the probe has moved: each new node takes the solution at the same patient
/// position in the previous mesh. Tissue that was outside the previous plane takes the solution at its projection onto
/// that plane.
class CarryOver {
 public:
  /// Stores the present mesh and solution.
  void keep(const Mesh& mesh, const Solver& solver);

  bool fits(const Mesh& mesh) const { return mesh.columns() == mesh_.columns() && mesh.rows() == mesh_.rows(); }
  /// Transfers the stored stress to the cells of a mesh of the same size; see cellOf().
  void transferStress(const Mesh& mesh, const Materials& materials, const Transform& keptFromNow,
                      Prestress& prestress) const;
  void shareSolution(const Mesh& mesh, const Materials& materials, const Transform& keptFromNow, Solver& solver) const;

 private:
  Mesh::Place placeOf(const Mesh& mesh, std::size_t node, const Transform& keptFromNow) const;
  /// Returns the cell of the stored mesh whose stress a new cell takes; `place` is the position of the new cell's first
  /// corner in the stored mesh, `mu` its shear modulus. If the cell at that position has a very different shear
  /// modulus, the neighbor with the most similar one is returned: the stress of a vessel wall, for example, would make
  /// the soft tissue beside the wall buckle.
  std::size_t cellOf(const Mesh::Place& place, float mu) const;

  Mesh mesh_;
  Nodes at_;
  std::vector<float> pressure_, mu_;
  Prestress prestress_;
};

}  // namespace insonate::elastic
