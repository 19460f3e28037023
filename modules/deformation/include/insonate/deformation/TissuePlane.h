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

/// Curvatures of a vessel's surface at a point near the surface: second derivatives of the distance to the surface, in
/// the image plane and perpendicular to it. The curvatures are (1/radius, 0) for a round vessel perpendicular to the
/// plane, and (0, 1/radius) for a round vessel in the plane.
struct OutlineCurvature {
  float inPlane_permm = 0, outOfPlane_permm = 0;
};

/// Interface by which deformation models read the undeformed tissue in the image plane of a probe at one pose. The
/// probe's face may lie inside the undeformed tissue; its depth in the tissue is the indentation.
class TissuePlane {
 public:
  virtual ~TissuePlane() = default;
  /// Writes the tissue at each point of `at` to `tissue`, which must be as long. Called on one thread at a time.
  virtual void sample(std::span<const PlanePoint> at, std::span<PlaneTissue> tissue) const = 0;
  /// Writes the curvature of a vessel's surface at each point of `at` to `bends`. `outline` is &PlaneTissue::artery_mm
  /// or &PlaneTissue::vein_mm. The default implementation, for planes without data on the tissue to either side, writes
  /// zeros: the vessel's wall then adds no stiffness.
  virtual void sampleCurvature(std::span<const PlanePoint> at, float PlaneTissue::*outline,
                               std::span<OutlineCurvature> bends) const {
    static_cast<void>(outline);
    std::ranges::fill(bends.first(at.size()), OutlineCurvature{});
  }
};

}  // namespace insonate
