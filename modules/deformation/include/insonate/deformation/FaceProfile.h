#pragma once

#include <insonate/deformation/DeformationModel.h>

namespace insonate {

/// Outline of a probe's face in its plane, probe frame, mm: flat or round, its ends rounded off by an arc that
/// continues until it is steeper than 60 degrees.
class FaceProfile {
 public:
  static constexpr float kEndRadius_mm = 3;

  explicit FaceProfile(const ProbeFace& face);

  struct Point {
    bool under = false;  ///< false: beside the face
    float z_mm = 0;
  };
  Point at(float x_mm) const;

  /// Extent from the middle, ends included.
  float reach_mm() const;

 private:
  float half_, radius_, edgeSine_, edgeCosine_;
};

}  // namespace insonate
