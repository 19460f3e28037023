#pragma once

#include <insonate/deformation/DeformationModel.h>

#include <optional>
#include <vector>

namespace insonate::press {

/// Range over which a face may be moved along its axis: from first contact with the skin to the point where the tissue
/// between face and bone cannot be compressed further. z in the frame of the plane.
struct FaceTravel {
  double touch_mm = 0;    ///< position of first contact; below 0: the face is already indented by that much
  double deepest_mm = 0;  ///< infinite if no bone lies below
};

/// Follows the plane from the face to the skin and to bone.
class FaceContact {
 public:
  explicit FaceContact(const ProbeFace& face);

  /// Finds the travel; empty if there is no skin within some centimeters before or behind the face. Allocates nothing
  /// from the second call on.
  std::optional<FaceTravel> find(const TissuePlane& plane);

 private:
  struct Column {
    float x_mm, face_mm;  ///< lateral position of the column, and axial position of the face there
  };
  std::vector<Column> columns_;
  std::vector<PlanePoint> points_;
  std::vector<PlaneTissue> tissue_;
};

}  // namespace insonate::press
