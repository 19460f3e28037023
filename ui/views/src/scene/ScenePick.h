#pragma once

#include <insonate/views/SceneView.h>

#include <array>

namespace insonate::views {

/// Returns the first voxel along a ray (patient's frame, LPS, mm) whose label is visible and that is not clipped away.
std::optional<ScenePick> firstVisible(const LabelMap& labels, Vec3 from_mm, Vec3 to_mm,
                                      const std::array<bool, 256>& visible,
                                      const std::optional<ClippingPlane>& clipping);

}  // namespace insonate::views
