#pragma once

#include <insonate/core/Transform.h>
#include <insonate/image/PlanePoint.h>
#include <insonate/ultrasound/AcousticScene.h>

#include <cstdint>
#include <span>
#include <vector>

namespace insonate {

/// Limit of signed distances, either way; a distance out of reach may read as up to half a voxel less.
inline constexpr float kPlaneReach_mm = 6;

/// Undisturbed tissue at points of a plane, one entry a point. The signed distances are those of the rendering,
/// negative inside the structure; kPlaneReach_mm for a structure that is not in the scene.
struct PlaneSamples {
  std::vector<std::uint8_t> label;  ///< of the structure that the point lies in: the nearest by signed distance
  std::vector<float> toArtery_mm, toVein_mm, toBone_mm;
  std::vector<float> toSkin_mm;  ///< to the body's outline, negative inside the body
};

/// Points outside the scene read as the outermost points within it. Allocates nothing once `tissue` has held as many
/// points. Any number of threads may ask one scene at a time.
void samplePlane(const AcousticScene& scene, const Transform& patientFromProbe, std::span<const PlanePoint> points,
                 PlaneSamples& tissue);

}  // namespace insonate
