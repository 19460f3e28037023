#pragma once

#include <insonate/deformation/DeformationModel.h>

namespace insonate::elastic {

/// Profile of the probe's face in its plane: flat or round, and rounded off at its ends.
class Face {
 public:
  static constexpr float kEndRadius_mm = 3;

  explicit Face(const ProbeFace& face);

  struct Point {
    bool under = false;  ///< false: beside the face
    float z_mm = 0, slope = 0;
  };
  Point at(float x_mm) const;

 private:
  float half_, radius_, edgeAngle_, edgeZ_;
};

}  // namespace insonate::elastic
