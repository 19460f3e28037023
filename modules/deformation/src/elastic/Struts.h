#pragma once

#include "elastic/Materials.h"

#include <vector>

namespace insonate::elastic {

/// Contact between the walls of a lumen: edges of the mesh inside the lumen act as one-sided springs, which push as
/// soon as their length along z (or x) falls below a minimum. The force is linear in the node positions, so that a
/// closing lumen needs no small steps.
class Struts {
 public:
  static constexpr float kLeft = 0.08f;  ///< share of the undeformed length below which a spring pushes
  static constexpr float kStiffness_kPa = 400;

  void prepare(const Mesh& mesh, const Materials& materials);
  void add(const Nodes& at, GridMatrix& matrix, std::vector<float>& force) const;

 private:
  struct Strut {
    int from, to;
    float min_mm, stiffness_kPa;
  };
  std::vector<Strut> down_, across_;
};

}  // namespace insonate::elastic
