#pragma once

#include "elastic/Mesh.h"

#include <vector>

namespace insonate::elastic {

/// A vessel along the plane is a slit in plane strain: only the surrounding tissue holds its walls, and an artery
/// would swell to twice its width with each beat. In the body its curved wall holds them. The wall's stiffness, as a
/// modulus of the lumen's change of area, A/A0 - 1, with r the radius and s the share of the outline's curvature that
/// is perpendicular to the plane (0 for a vessel perpendicular to it, which the mesh then represents fully):
///
/// wider     s (E/(1-0.49^2) h/r + 2 mu)   a thin tube of wall h under pressure, in loose tissue
///
/// narrower  s 3 p, at most that           a round tube under the tension of its pressure p, bent oval (n = 2)
struct TubeStiffness {
  float wider_kPa = 0, narrower_kPa = 0;
};

/// Stiffness of one vessel under the pressure at which the CT was taken; `bend` is a mean over its outline.
TubeStiffness tubeStiffness(const MechanicalTissue& vessel, const OutlineBend& bend);

/// One a cell, numbered as in Mesh::middle(), of what of a vessel's connected part lies in this plane. `shares` of the
/// cells that are lumen.
class TubeFinder {
 public:
  void find(const Mesh& mesh, const TissuePlane& plane, float PlaneTissue::*outline, const MechanicalTissue& vessel,
            const std::vector<float>& shares, std::vector<TubeStiffness>& stiffness);

 private:
  OutlineBend meanBend(const Mesh& mesh, const TissuePlane& plane, float PlaneTissue::*outline,
                       const std::vector<float>& shares);

  std::vector<char> seen_;
  std::vector<std::size_t> part_;
  std::vector<PlanePoint> points_;
  std::vector<OutlineBend> bends_;
};

}  // namespace insonate::elastic
