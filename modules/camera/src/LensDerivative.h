#pragma once

#include <insonate/camera/LensModel.h>

#include <optional>

namespace insonate::camera {

/// Place of a point in the image, and its derivatives by the point's position (pixels per mm).
struct Projection {
  FramePoint pixel;
  Vec3 dx, dy;
};

/// As project(), with the derivatives.
std::optional<Projection> projectWithDerivative(const LensModel& lens, Vec3 point_camera);

}  // namespace insonate::camera
