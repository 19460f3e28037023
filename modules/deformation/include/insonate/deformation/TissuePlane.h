#pragma once

#include <insonate/image/PlanePoint.h>

#include <algorithm>
#include <cstdint>
#include <span>

namespace insonate {

/// Undeformed tissue at a point.
struct PlaneTissue {
  static constexpr float kFar_mm = 6;  ///< distances are cut off here

  std::uint8_t label = 0;  ///< of insonate/tissue/Labels.h; 0 outside the body
  float artery_mm = kFar_mm, vein_mm = kFar_mm,
        bone_mm = kFar_mm;   ///< to the structure, negative inside it
  float skin_mm = -kFar_mm;  ///< to the skin, negative inside the body
};

/// Curvature of a vessel's outline at a point near it, 1/mm, as a second derivative of the distance to it: in the
/// plane, and perpendicular to it. A round vessel perpendicular to the plane has (1/radius, 0), one along the plane
/// (0, 1/radius).
struct OutlineBend {
  float within_permm = 0, across_permm = 0;
};

/// The patient's tissue in the plane of the image, undeformed: what a model
/// asks for. The plane belongs to a pose of the probe, whose face may lie
/// inside the tissue: that is how deep it presses.
class TissuePlane {
 public:
  virtual ~TissuePlane() = default;
  /// Samples the tissue at any number of points; `tissue` is as long as `at`. Called on one thread at a time.
  virtual void sample(std::span<const PlanePoint> at, std::span<PlaneTissue> tissue) const = 0;
  /// Curvature of the artery's or the vein's outline. A plane without knowledge beyond itself takes all vessels as
  /// perpendicular to it.
  virtual void bend(std::span<const PlanePoint> at, float PlaneTissue::*outline, std::span<OutlineBend> bends) const {
    static_cast<void>(outline);
    std::ranges::fill(bends.first(at.size()), OutlineBend{});
  }
};

}  // namespace insonate
