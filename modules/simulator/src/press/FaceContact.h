#pragma once

#include <insonate/deformation/DeformationModel.h>

#include <optional>
#include <vector>

namespace insonate::press {

/// Positions along the probe's axis (z of the probe frame) of first contact with the skin, and of maximum compression
/// of the tissue between the probe's face and bone.
struct FaceTravel {
  double touch_mm = 0;  ///< position of first contact with the skin; below 0: the face is already indented by that much
  double deepest_mm = 0;  ///< deepest position of the face, at maximum compression; infinite: there is no bone
};

/// Searches the image plane from the probe's face for skin and bone.
class FaceContact {
 public:
  explicit FaceContact(const ProbeFace& face);

  /// Finds first contact and deepest position of the face; empty if there is no skin within some centimeters in front
  /// of or behind the face. Allocates nothing from the second call on.
  std::optional<FaceTravel> find(const TissuePlane& plane);

 private:
  struct Column {
    /// lateral position of a column of searched points, and axial position of the probe's face there
    float x_mm, face_mm;
  };
  std::vector<Column> columns_;
  std::vector<PlanePoint> points_;
  std::vector<PlaneTissue> tissue_;
};

}  // namespace insonate::press
