#pragma once

#include <insonate/core/Vec3.h>

#include <array>

namespace insonate {

/// 3x3 matrix, stored as its columns: column k is the image of the k-th unit vector.
struct Mat3 {
  std::array<Vec3, 3> column{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  constexpr bool operator==(const Mat3&) const = default;
};

constexpr Vec3 operator*(const Mat3& m, Vec3 v) {
  return m.column[0] * v.x + m.column[1] * v.y + m.column[2] * v.z;
}
constexpr Mat3 operator*(const Mat3& a, const Mat3& b) {
  return {{a * b.column[0], a * b.column[1], a * b.column[2]}};
}
constexpr Mat3 transposed(const Mat3& m) {
  const auto& c = m.column;
  return {{Vec3{c[0].x, c[1].x, c[2].x}, Vec3{c[0].y, c[1].y, c[2].y}, Vec3{c[0].z, c[1].z, c[2].z}}};
}
constexpr double determinant(const Mat3& m) {
  return dot(m.column[0], cross(m.column[1], m.column[2]));
}
/// Returns the inverse of a matrix; undefined if the matrix is singular.
constexpr Mat3 inverted(const Mat3& m) {
  const auto& c = m.column;
  const double d = determinant(m);
  return transposed({{cross(c[1], c[2]) / d, cross(c[2], c[0]) / d, cross(c[0], c[1]) / d}});
}

/// Maps a point: x_target = linear * x_source + offset. Variables are named targetFromSource, so that products read as
/// a chain: patientFromIndex = patientFromProbe * probeFromIndex.
struct Transform {
  Mat3 linear;
  Vec3 offset;
  constexpr bool operator==(const Transform&) const = default;
};

constexpr Vec3 operator*(const Transform& t, Vec3 point) {
  return t.linear * point + t.offset;
}
constexpr Transform operator*(const Transform& a, const Transform& b) {
  return {a.linear * b.linear, a.linear * b.offset + a.offset};
}
constexpr Transform inverted(const Transform& t) {
  const Mat3 i = inverted(t.linear);
  return {i, -(i * t.offset)};
}

}  // namespace insonate
