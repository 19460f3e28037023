#pragma once

#include <insonate/image/PlanePoint.h>

#include <algorithm>
#include <cstdint>
#include <span>

namespace insonate {

/// Undeformed tissue at a point of the image plane.
struct PlaneTissue {
  static constexpr float kFar_mm = 6;  ///< maximum absolute value of the distances below

  std::uint8_t label = 0;  ///< label of insonate/tissue/Labels.h; 0 outside the body
  float artery_mm = kFar_mm, vein_mm = kFar_mm,
        bone_mm = kFar_mm;   ///< distances to artery, vein and bone, negative inside the structure
  float skin_mm = -kFar_mm;  ///< distance to the skin, negative inside the body
};

/// Curvature of a vessel's outline at a point near it, 1/mm: second derivatives of the distance to the outline, in the
/// plane (`within`) and perpendicular to it (`across`). A round vessel perpendicular to the plane has (1/radius, 0),
/// one along the plane (0, 1/radius).
struct OutlineCurvature {
  float inPlane_permm = 0, outOfPlane_permm = 0;
};

/// Undeformed tissue in the image plane, in the form in which deformation models query it. The plane belongs to a pose
/// of the probe; the face may lie inside the undeformed tissue, and its depth there is the indentation.
class TissuePlane {
 public:
  virtual ~TissuePlane() = default;
  /// Samples the tissue at any number of points; `tissue` must be as long as `at`. Called on one thread at a time.
  virtual void sample(std::span<const PlanePoint> at, std::span<PlaneTissue> tissue) const = 0;
  /// Returns the curvature of the artery's or the vein's outline. The default implementation, for planes without data
  /// on the tissue to either side, treats all vessels as perpendicular to the plane.
  virtual void sampleCurvature(std::span<const PlanePoint> at, float PlaneTissue::*outline,
                               std::span<OutlineCurvature> bends) const {
    static_cast<void>(outline);
    std::ranges::fill(bends.first(at.size()), OutlineCurvature{});
  }
};

}  // namespace insonate
