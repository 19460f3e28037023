#pragma once

#include <insonate/core/Vec3.h>

#include <vector>

namespace insonate {

/// Displacement of the tissue in the probe's plane, as an inverse map: for a point of the image, the vector to the
/// place of its tissue in the undeformed patient. On a regular lattice in the probe frame (x lateral, z axial), mm.
/// Bilinear between its points, constant beyond them; one-to-one, so that no tissue shows twice. Where there is no
/// tissue, it holds the displacement of the nearest tissue. It also holds across the slice: neighboring elevation
/// planes move with the central one.
struct PlaneDisplacement {
  double left_mm = 0, top_mm = 0;  ///< x and z of the first point
  double step_mm = 1;              ///< between points, both ways; above 0
  int columns = 0, rows = 0;       ///< none of either: nothing has moved

  struct Shift {
    float x_mm = 0, z_mm = 0;  ///< rest point minus seen point
  };
  std::vector<Shift> restFromSeen;  ///< [row][column]

  bool empty() const { return columns == 0 || rows == 0; }
};

/// Rest point minus seen point (no y), for a seen point of the probe's plane. Zero where nothing has moved.
Vec3 shiftAt(const PlaneDisplacement& displacement, double x_mm, double z_mm);

}  // namespace insonate
