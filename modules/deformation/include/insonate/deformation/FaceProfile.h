#pragma once

#include <insonate/deformation/DeformationModel.h>

namespace insonate {

/// Outline of a probe's face in the image plane, probe frame: flat or an arc. A smaller arc of radius kEndRadius_mm
/// rounds each end, up to a slope of 60 degrees.
class FaceProfile {
 public:
  static constexpr float kEndRadius_mm = 3;

  explicit FaceProfile(const ProbeFace& face);

  struct Point {
    bool under = false;  ///< true if x lies within the outline; false beside the face
    float z_mm = 0;
  };
  /// Returns the point of the outline at a lateral position.
  Point at(float x_mm) const;

  /// Returns the lateral distance from the middle to each end of the outline, including the rounded ends.
  float reach_mm() const;

 private:
  float half_, radius_, edgeSine_, edgeCosine_;
};

}  // namespace insonate
