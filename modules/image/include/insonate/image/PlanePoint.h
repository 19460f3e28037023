#pragma once

namespace insonate {

/// A point of the image plane, in the probe frame: x lateral, z axial.
struct PlanePoint {
  float x_mm = 0, z_mm = 0;
};

}  // namespace insonate
