#pragma once

#include <insonate/core/Transform.h>
#include <insonate/image/PlanePoint.h>
#include <insonate/ultrasound/AcousticScene.h>

#include <cstdint>
#include <span>
#include <vector>

namespace insonate {

/// Maximum absolute value of the signed distances in PlaneSamples; a larger distance may read as up to half a voxel
/// less than this maximum.
inline constexpr float kPlaneReach_mm = 6;

/// Tissue at rest (not displaced) at points of a plane, one entry per point. The signed distances are those by which
/// images are rendered, negative inside the structure. For a structure that is not in the scene the distance is
/// kPlaneReach_mm.
struct PlaneSamples {
  std::vector<std::uint8_t> label;  ///< label of the structure at the point: the nearest structure by signed distance
  std::vector<float> toArtery_mm, toVein_mm, toBone_mm;
  std::vector<float> toSkin_mm;  ///< distance to the body's outline, negative inside the body
};

/// Samples a scene at points of a plane. Points outside the scene read as the outermost points within it. Allocates
/// nothing if `tissue` has held as many points before. Any number of threads may sample one scene at the same time.
void samplePlane(const AcousticScene& scene, const Transform& patientFromProbe, std::span<const PlanePoint> points,
                 PlaneSamples& tissue);

}  // namespace insonate
