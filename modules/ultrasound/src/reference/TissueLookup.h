#pragma once

#include "model/Contact.h"
#include "model/FramePlan.h"
#include "scene/SceneData.h"

#include <vector>

namespace insonate {

/// Tissue at one gate of one scanline in one elevation plane.
struct TissueSample {
  Vec3 patient_mm;       ///< undeformed position of the tissue at the gate
  bool inside = true;    ///< true if the gate lies within the volume
  bool outside = false;  ///< true if the gate is in front of the skin, in gel
  std::uint8_t label = 0;
  int cell = 0;          ///< number of the lattice cell along this scanline
  int pair = 0;          ///< number that identifies the cell's two nearest structures
  double s_mm = 0;       ///< signed distance to the boundary between the cell's two nearest structures
  double cosine = 1;     ///< cosine of the beam's incidence on the boundary
  double spread_mm = 0;  ///< difference in the boundary's depth between neighboring scanlines and planes
  double impedance_MRayl = 0;
  double echo_dB = 0;  ///< level of scattering; 0 dB is speckle of RMS amplitude 1
  double sheet = 0;  ///< share of the echo that is coherent: 0: individual scatterers; 1: a sheet of connective tissue
  double patch = 0;  ///< value of the random field, of SD 1, that varies boundaries and layers
  bool grazesVessel = false;
};

/// Looks up the tissue along every scanline. Signed distances to the structures are read at the nodes of a lattice in
/// beam coordinates and interpolated in its cells; each cell stores its two nearest structures.
class TissueLookup {
 public:
  TissueLookup(const FramePlan& plan, const AcousticScene::Impl& scene, const Transform& patientFromProbe,
               const PlaneDisplacement& displacement);

  TissueSample at(int plane, int gate, int line) const;
  /// Returns the contact of a scanline with the skin, interpolated between the columns of the lattice.
  Contact contact(int line) const;
  /// Returns the first gate in gas behind tissue on a scanline of the central plane; -1 if there is none.
  int firstGasGate(int line) const;

 private:
  struct Node {
    std::array<double, TissueField::kStride> distance_mm{};
    double ctDeviation = 0;
    double patch = 0, wander_mm = 0;  ///< patch: random variation of a boundary's strength, SD 1; wander_mm: shift of
                                      ///< the boundary's layers
    bool inside = true;
  };
  struct Cell {
    int a = 0, b = 0;
    double s[4]{};  ///< signed distance to the boundary, mm, at the cell's corners: row, then column
    double cosine = 1, spread_mm = 0, ctDeviation = 0;
    double patch[4] = {}, wander_mm[4] = {};
    bool inside = true;
  };

  Vec3 seenPoint(int plane, double gate, double line, double gap_mm) const;
  Vec3 nodeShift(int row, int column) const;
  Vec3 gateShift(int gate, int line) const;
  Node nodeAt(int plane, int row, int column) const;
  const Node& node(int plane, int row, int column) const;
  Cell cellOf(int plane, int row, int column) const;
  double elevationSlope(int plane, int row, int column, const Cell& cell, double axial, double lateral) const;
  double inPlaneSlopeAtRest(int row, int column, double axial, double lateral) const;
  void addTexture(TissueSample& sample, const Cell& cell, Vec3 beam) const;
  void addLayers(TissueSample& sample, const Cell& cell, double patch, double wander_mm) const;

  const FramePlan& plan_;
  const AcousticScene::Impl& scene_;
  Transform patientFromProbe_;
  const PlaneDisplacement& displacement_;
  std::vector<Contact> contacts_;  ///< contact at each column of the lattice
  /// Rest position minus displayed position of the tissue at the lattice nodes, [row][column], probe frame; empty if no
  /// tissue is displaced.
  std::vector<Vec3> shifts_;
  std::vector<Node> nodes_;
};

}  // namespace insonate
