#pragma once

namespace insonate::views {

/// Position of a lamp relative to the camera's focal point, right, up and toward the viewer, and its intensity.
struct SceneLight {
  double x, y, z, intensity;
};

/// A key light above the camera and a soft fill light from below; both move with the camera.
inline constexpr SceneLight kSceneLights[] = {{-0.35, 0.6, 1, 0.85}, {0.5, -0.35, 0.6, 0.28}};

}  // namespace insonate::views
