#pragma once

#include <insonate/camera/SimulatedCamera.h>
#include <insonate/camera/TagDetector.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace insonate::test {

/// Lens of a usual laptop camera at 1280 x 720, with barrel distortion.
inline LensModel laptopLens() {
  LensModel lens = lensWithoutDistortion(1280, 720, 68);
  lens.cx_px += 7, lens.cy_px -= 5;
  lens.k1 = 0.08, lens.k2 = -0.18, lens.p1 = 0.001, lens.p2 = -0.0006;
  return lens;
}

inline TagBody bodyNamed(const char* name) {
  auto body = loadTagBody(name);
  if (!body) throw std::runtime_error(body.error().message);
  return *body;
}

/// Rotation by `angle_deg` about an axis.
inline Mat3 turned(Vec3 axis, double angle_deg) {
  const Vec3 k = normalized(axis);
  const double angle = angle_deg * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
  Mat3 m;
  for (int i = 0; i < 3; ++i) {
    Vec3 e;
    e[i] = 1;
    m.column[std::size_t(i)] = e * c + cross(k, e) * s + k * (dot(k, e) * (1 - c));
  }
  return m;
}

inline double angleBetween_deg(Vec3 a, Vec3 b) {
  return std::atan2(norm(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
}

/// A body at rest.
inline SimulatedObject atRest(const TagBody& body, const Transform& cameraFromBody) {
  return {body, [cameraFromBody](double) { return cameraFromBody; }, {}};
}

/// The tool's tip in the camera frame.
inline Vec3 tipOf(const TagBody& body, const Transform& cameraFromBody) {
  return cameraFromBody * body.bodyFromTool.offset;
}

inline std::vector<TagDetection> detectAll(const CameraFrame& frame) {
  std::vector<TagDetection> found;
  TagDetector().detect(frame.view(), {0, 0, frame.width, frame.height}, 1, found);
  return found;
}

}  // namespace insonate::test
