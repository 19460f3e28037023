#pragma once

#include "elastic/Mesh.h"
#include "elastic/TubeStiffness.h"

namespace insonate::elastic {

/// Materials of each cell of a mesh: shares of lumen, wall, loose tissue and of the tissue at its corners.
struct Materials {
  static constexpr float kGasMu_kPa = 0.02f;  ///< next to nothing: keeps cells in order
  static constexpr bool isGas(float mu_kPa) { return mu_kPa < 2 * kGasMu_kPa; }

  std::vector<float> mu, bulk;                ///< kPa
  std::vector<float> hoop;                    ///< kPa, beside bulk where a lumen becomes wider: see TubeStiffness.h
  std::vector<float> artery, vein;            ///< shares of a cell's area, whatever they are made of, 0..1
  std::vector<float> arteryBlood, veinBlood;  ///< the same where they are lumens, else 0
  std::vector<char> fixed;                    ///< [node]: does not move
  bool anyBlood = false;

  void fill(const Mesh& mesh, const TissuePlane& plane, const MechanicalTable& tissues);

 private:
  void addTubes(const Mesh& mesh, const TissuePlane& plane, const MechanicalTable& tissues);

  TubeFinder tubes_;
  std::vector<TubeStiffness> tube_;
};

}  // namespace insonate::elastic
