#pragma once

#include <insonate/views/SceneView.h>

#include <array>

namespace insonate::views {

/// The first voxel along a ray (patient LPS mm) whose label is visible and which no plane has clipped away.
std::optional<ScenePick> firstVisible(const LabelMap& labels, Vec3 from_mm, Vec3 to_mm,
                                      const std::array<bool, 256>& visible,
                                      const std::optional<ClippingPlane>& clipping);

}  // namespace insonate::views
