#pragma once

#include <insonate/core/Vec3.h>

#include <array>
#include <vector>

namespace insonate {

/// Motion of the lungs along the pleura.
struct LungMotion {
  /// Distance by which the lungs have slid toward the patient's head, compared with the CT.
  double slide_mm = 0;
  /// Parts of the right and of the left lung that a pneumothorax has detached from the chest wall, and that do not
  /// slide: up to this distance to the side of the trachea, where the lung point is; 0: no pneumothorax.
  std::array<double, 2> detached_mm{};

  bool operator==(const LungMotion&) const = default;
};

/// Displacement of the tissue in the image plane, as an inverse map: for each point of the image, the vector to the
/// position of the same tissue in the undeformed patient. The vectors are stored at the points of a regular lattice in
/// the probe frame (x lateral, z axial), mm. They are interpolated bilinearly between the points and are constant
/// beyond the lattice. The map is one-to-one: no tissue appears twice. A point without tissue has the displacement of
/// the nearest tissue. Tissue beside the image plane, within the slice thickness, has the displacement of the image
/// plane.
struct PlaneDisplacement {
  double left_mm = 0, top_mm = 0;  ///< x and z of the first lattice point, probe frame
  double step_mm = 1;              ///< distance between neighboring lattice points, the same along x and z; above 0
  int columns = 0, rows = 0;       ///< number of lattice points along x and along z; 0 if no tissue is displaced

  struct Shift {
    float x_mm = 0, z_mm = 0;  ///< undeformed position minus displayed position of the tissue
  };
  std::vector<Shift>
      restFromDisplayed;  ///< vector for the tissue that the image shows at each lattice point, index [row][column]

  LungMotion lung{};  ///< the lungs slide also if no other tissue is displaced

  bool empty() const { return columns == 0 || rows == 0; }
};

/// Returns the vector from a point of the image to the undeformed position of its tissue, probe frame; its y is 0.
/// Returns zero if no tissue is displaced.
Vec3 shiftAt(const PlaneDisplacement& displacement, double x_mm, double z_mm);

}  // namespace insonate
