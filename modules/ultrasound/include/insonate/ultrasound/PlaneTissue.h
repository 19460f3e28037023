#pragma once

#include <insonate/core/Transform.h>
#include <insonate/image/PlanePoint.h>
#include <insonate/ultrasound/AcousticScene.h>

#include <cstdint>
#include <span>
#include <vector>

namespace insonate {

/// Maximum absolute value of the signed distances in PlaneSamples. A larger distance is returned as this value, or as a
/// value that is smaller by up to half a voxel.
inline constexpr float kPlaneReach_mm = 6;

/// Undeformed tissue at points of a plane, one entry per point. Images are rendered from the same signed distances;
/// they are negative inside the structure. The distance to a structure that the scene does not contain is
/// kPlaneReach_mm.
struct PlaneSamples {
  std::vector<std::uint8_t> label;  ///< label of the structure at the point: the nearest structure by signed distance
  std::vector<float> toArtery_mm, toVein_mm, toBone_mm;
  std::vector<float> toSkin_mm;  ///< distance to the body's outline, negative inside the body
};

/// Samples a scene at points of the image plane. A point outside the scene has the values of the outermost point of the
/// scene. Allocates nothing if `tissue` has had as many points before. Any number of threads may sample one scene at
/// the same time.
void samplePlane(const AcousticScene& scene, const Transform& patientFromProbe, std::span<const PlanePoint> points,
                 PlaneSamples& tissue);

}  // namespace insonate
