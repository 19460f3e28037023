#pragma once

#include "elastic/Mesh.h"
#include "elastic/VesselWall.h"

namespace insonate::elastic {

/// Material of each cell of a mesh: a mixture of lumen, wall, loose tissue and the tissue at the cell's corners, by
/// their shares.
struct Materials {
  static constexpr float kGasMu_kPa = 0.02f;  ///< shear modulus of gas: very soft, only to keep cells regular
  static constexpr bool isGas(float mu_kPa) { return mu_kPa < 2 * kGasMu_kPa; }

  std::vector<float> mu, bulk;  ///< shear modulus mu and area modulus bulk (lambda + mu) of each cell, kPa
  std::vector<float> hoop;  ///< modulus of each cell that is added to bulk while a lumen is wider than at rest, kPa;
                            ///< see VesselWall.h
  /// Share of a cell's area inside an artery or a vein, whatever the material of the vessel; 0 to 1. The share is 0
  /// beside the blocks of small cells (MeshLines::across).
  std::vector<float> artery, vein;
  /// Share of a cell's area inside an artery or a vein that contains blood (Mechanics::Lumen); else 0.
  std::vector<float> arteryBlood, veinBlood;
  std::vector<char> fixed;  ///< [node] true if the node does not move
  bool anyBlood = false;

  void fill(const Mesh& mesh, const TissuePlane& plane, const MechanicalTable& tissues);

 private:
  void addTubes(const Mesh& mesh, const TissuePlane& plane, const MechanicalTable& tissues);

  TubeFinder tubes_;
  std::vector<TubeStiffness> tube_;
};

}  // namespace insonate::elastic
