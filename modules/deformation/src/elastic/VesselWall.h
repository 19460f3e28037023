#pragma once

#include "elastic/Mesh.h"

#include <vector>

namespace insonate::elastic {

/// The collagen of a vessel's wall resists from the relative area `above` on: its pressure is
/// modulus_kPa (A/A0 - above)^2. Elastin alone carries a pulse, which changes the area of a carotid artery by 15 % or
/// less; in healthy people the internal jugular vein reaches about twice its area by Valsalva maneuver and head-down
/// tilt.
struct Collagen {
  float above, modulus_kPa;
};
inline constexpr Collagen kArteryCollagen{1.2f, 200}, kVeinCollagen{1.8f, 10};

/// Stiffness that a vessel's curved wall adds. Without it, in plane strain, a vessel along the plane would be a slit
/// whose walls are held only by the surrounding tissue, and an artery would swell to twice its width with each beat; in
/// the body, the tension of the curved wall prevents this. The stiffness is a modulus of the lumen's relative change of
/// area, A/A0 - 1. r is the vessel's radius, s the share of the outline's curvature that is perpendicular to the plane.
/// s is 0 for a vessel perpendicular to the plane, which the mesh represents completely.
///
/// wider:    s (E/(1-0.49^2) h/r + 2 mu): a thin tube under pressure in loose tissue; the wall has thickness h and
///           Young's modulus E, the loose tissue the shear modulus mu.
///
/// narrower: s 3 p, limited to the value for wider: a round tube under the tension of its pressure p, bent oval
///           (mode n = 2).
struct TubeStiffness {
  float wider_kPa = 0, narrower_kPa = 0;
};

/// Returns the stiffness that the curved wall of one vessel adds, under the pressure at which the CT was taken; `bend`
/// is the mean curvature of the vessel's outline.
TubeStiffness tubeStiffness(const MechanicalTissue& vessel, const OutlineCurvature& bend);

/// Finds the stiffness that vessel walls add to each cell, numbered as in Mesh::middle(): all cells of a connected part
/// of a vessel in this plane get the same value. `shares` are the shares of the cells' areas that are lumen.
class TubeFinder {
 public:
  void find(const Mesh& mesh, const TissuePlane& plane, float PlaneTissue::*outline, const MechanicalTissue& vessel,
            const std::vector<float>& shares, std::vector<TubeStiffness>& stiffness);

 private:
  OutlineCurvature meanBend(const Mesh& mesh, const TissuePlane& plane, float PlaneTissue::*outline,
                            const std::vector<float>& shares);

  std::vector<char> seen_;
  std::vector<std::size_t> part_;
  std::vector<PlanePoint> points_;
  std::vector<OutlineCurvature> bends_;
};

}  // namespace insonate::elastic
