#pragma once

namespace insonate::views {

/// Position of a lamp relative to the camera's focal point: right, up, toward the viewer.
struct SceneLight {
  double x, y, z, intensity;
};

/// A key above the camera and a soft fill from below, moving with it.
inline constexpr SceneLight kSceneLights[] = {{-0.35, 0.6, 1, 0.85}, {0.5, -0.35, 0.6, 0.28}};

}  // namespace insonate::views
