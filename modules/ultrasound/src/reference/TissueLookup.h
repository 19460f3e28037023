#pragma once

#include "model/Contact.h"
#include "model/FramePlan.h"
#include "scene/SceneData.h"

#include <vector>

namespace insonate {

/// Tissue at one gate of one scanline in one elevation plane.
struct TissueSample {
  Vec3 patient_mm;       ///< position of the gate in tissue at rest
  bool inside = true;    ///< within the volume
  bool outside = false;  ///< the gate is in front of the skin, in gel
  std::uint8_t label = 0;
  int cell = 0;          ///< number of the cell along this scanline
  int pair = 0;          ///< identifies the two structures of the cell
  double s_mm = 0;       ///< signed distance to the boundary between the two structures
  double cosine = 1;     ///< cosine of the beam's incidence on the boundary
  double spread_mm = 0;  ///< depth range of the boundary between neighboring scanlines and planes
  double impedance_MRayl = 0;
  double echo_dB = 0;  ///< scattering relative to unit speckle
  double sheet = 0;    ///< 0: individual scatterers .. 1: a sheet, which echoes coherently
  double roughness_dB = 0;
  bool grazesVessel = false;
};

/// Structures along every scanline: signed distances are looked up at the nodes of a lattice in beam coordinates and
/// interpolated in its cells; each cell stores its two nearest structures.
class TissueLookup {
 public:
  TissueLookup(const FramePlan& plan, const AcousticScene::Impl& scene, const Transform& patientFromProbe,
               const PlaneDisplacement& displacement);

  TissueSample at(int plane, int gate, int line) const;
  /// Contact of a scanline, interpolated between the columns of the lattice.
  Contact contact(int line) const;
  /// First gate in gas behind tissue, in the central plane; -1 if there is none.
  int firstGasGate(int line) const;

 private:
  struct Node {
    std::array<double, TissueField::kStride> distance_mm{};
    double ctDeviation = 0;
    double patch = 0, wander_mm = 0;  ///< variation of a boundary's strength, with SD 1; shift of the boundary's layers
    bool inside = true;
  };
  struct Cell {
    int a = 0, b = 0;
    double s[4]{};  ///< mm at the corners: row, then column
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
  std::vector<Contact> contacts_;  ///< [column]
  /// [row][column], probe frame: rest position minus displayed position; empty if nothing has moved.
  std::vector<Vec3> shifts_;
  std::vector<Node> nodes_;
};

}  // namespace insonate
