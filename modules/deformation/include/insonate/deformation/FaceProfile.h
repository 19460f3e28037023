#pragma once

#include <insonate/deformation/DeformationModel.h>

namespace insonate {

/// Outline of a probe's face in its plane, probe frame, mm: flat or round. An arc rounds each end and continues up to a
/// slope of 60 degrees.
class FaceProfile {
 public:
  static constexpr float kEndRadius_mm = 3;

  explicit FaceProfile(const ProbeFace& face);

  struct Point {
    bool under = false;  ///< true if x lies within the outline; false beside the face
    float z_mm = 0;
  };
  Point at(float x_mm) const;

  /// Returns the distance from the middle to each end of the outline, rounded ends included.
  float reach_mm() const;

 private:
  float half_, radius_, edgeSine_, edgeCosine_;
};

}  // namespace insonate
