#pragma once

#include <insonate/camera/CameraFrame.h>
#include <insonate/core/Result.h>
#include <insonate/core/Vec3.h>

#include <filesystem>
#include <optional>
#include <string_view>

namespace insonate {

/// Projection of a camera: pinhole with radial and tangential distortion (Brown 1966). The camera frame has its origin
/// at the optical center, x to the right and y down in the image, z forward; mm. With x' = x/z, y' = y/z and
/// r^2 = x'^2 + y'^2, a point appears at
///   u = fx (x' (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 x' y' + p2 (r^2 + 2 x'^2)) + cx,
///   v = fy (y' (1 + k1 r^2 + k2 r^4 + k3 r^6) + p1 (r^2 + 2 y'^2) + 2 p2 x' y') + cy.
struct LensModel {
  int width = 0, height = 0;  ///< size of the image for which the values hold, pixels
  double fx_px = 0, fy_px = 0, cx_px = 0, cy_px = 0;
  double k1 = 0, k2 = 0, k3 = 0, p1 = 0, p2 = 0;
};

/// Returns a lens without distortion whose image is `horizontal_deg` wide; the optical axis is in the image's middle.
LensModel lensWithoutDistortion(int width, int height, double horizontal_deg);

/// Returns the place of a point (camera frame, mm) in the image; no value if the point is not in front of the camera,
/// or so far from the axis that the distortion is not monotonic there.
std::optional<FramePoint> project(const LensModel& lens, Vec3 point_camera);

/// Returns the direction, with z = 1, of the ray that arrives at a point of the image. The error is below 1e-9 wherever
/// the distortion is monotonic.
Vec3 rayThrough(const LensModel& lens, FramePoint pixel);

/// Returns the same lens for images of another size from the same sensor: all lengths in pixels are scaled.
LensModel scaledLens(const LensModel& lens, int width, int height);

/// Reads a lens from the JSON text that lensText() writes. Fails with a sentence if a value is missing or out of range.
Result<LensModel> parseLens(std::string_view json);
std::string lensText(const LensModel& lens);
/// Reads and writes a file with lensText().
Result<LensModel> readLens(const std::filesystem::path& file);
Result<void> writeLens(const LensModel& lens, const std::filesystem::path& file);

}  // namespace insonate
