#pragma once

#include <insonate/deformation/DeformationModel.h>

#include <optional>
#include <vector>

namespace insonate::press {

/// Range over which a face may be moved along its axis: from first contact with the skin to the point where no tissue
/// between face and bone can give way. z in the frame of the plane.
struct FaceTravel {
  double touch_mm = 0;    ///< below 0: it has been pressed in by that much
  double deepest_mm = 0;  ///< infinite where no bone lies below
};

/// Follows the plane from the face to skin and bone.
class FaceContact {
 public:
  explicit FaceContact(const ProbeFace& face);

  /// Finds the travel; empty if no skin lies before or behind the face, within some centimeters. Allocates nothing the
  /// second time.
  std::optional<FaceTravel> find(const TissuePlane& plane);

 private:
  struct Column {
    float x_mm, face_mm;  ///< and where the face is
  };
  std::vector<Column> columns_;
  std::vector<PlanePoint> points_;
  std::vector<PlaneTissue> tissue_;
};

}  // namespace insonate::press
