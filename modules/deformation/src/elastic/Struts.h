#pragma once

#include "elastic/Materials.h"

#include <vector>

namespace insonate::elastic {

/// Contact of a lumen's walls: the mesh's edges inside the lumen are one-sided springs that push once little of their
/// length along z (or x) is left. Linear in the positions, so that closing needs no small steps.
class Struts {
 public:
  static constexpr float kLeft = 0.08f;  ///< of the length at rest, at which they begin to push
  static constexpr float kStiffness_kPa = 400;

  void prepare(const Mesh& mesh, const Materials& materials);
  void add(const Nodes& at, GridMatrix& matrix, std::vector<float>& force) const;

 private:
  struct Strut {
    int from, to;
    float least_mm, stiffness_kPa;
  };
  std::vector<Strut> down_, across_;
};

}  // namespace insonate::elastic
