#pragma once

#include "Matrix.h"

#include <insonate/core/Transform.h>

#include <cmath>

/// Small motions. A motion of a body is (v, w): its origin moves by v, and it turns about its origin by the rotation
/// vector w (its length is the angle, its direction the axis); both in the axes of the outer frame.
namespace insonate::camera {

using Motion = Vector<6>;

inline Vec3 shiftOf(const Motion& m) {
  return {m[0], m[1], m[2]};
}
inline Vec3 turnOf(const Motion& m) {
  return {m[3], m[4], m[5]};
}

/// Returns the rotation by the vector `w` (Rodrigues).
inline Mat3 rotationBy(Vec3 w) {
  const double angle = norm(w);
  const double s = angle > 1e-8 ? std::sin(angle) / angle : 1;
  const double c = angle > 1e-8 ? (1 - std::cos(angle)) / (angle * angle) : 0.5;
  Mat3 m;
  for (int i = 0; i < 3; ++i) {
    Vec3 e;
    e[i] = 1;
    m.column[std::size_t(i)] = e + cross(w, e) * s + cross(w, cross(w, e)) * c;
  }
  return m;
}

/// Returns the vector of the rotation `m`, at most pi long; the inverse of rotationBy(). Goes through the quaternion
/// whose largest component is computed first (Shepperd 1978), which is exact near pi, too.
inline Vec3 rotationVector(const Mat3& m) {
  const auto at = [&](int r, int c) { return m.column[std::size_t(c)][r]; };
  const double trace = at(0, 0) + at(1, 1) + at(2, 2);
  int largest = 3;
  for (int i = 0; i < 3; ++i)
    if (at(i, i) > (largest == 3 ? trace : at(largest, largest))) largest = i;
  double w = 0;
  Vec3 v;
  if (largest == 3) {
    w = 1 + trace;
    v = {at(2, 1) - at(1, 2), at(0, 2) - at(2, 0), at(1, 0) - at(0, 1)};
  } else {
    const int i = largest, j = (i + 1) % 3, k = (i + 2) % 3;
    w = at(k, j) - at(j, k);
    v[i] = 1 + at(i, i) - at(j, j) - at(k, k);
    v[j] = at(i, j) + at(j, i), v[k] = at(i, k) + at(k, i);
    if (w < 0) w = -w, v = -v;
  }
  const double length = norm(v);
  return length > 1e-300 ? v * (2 * std::atan2(length, w) / length) : Vec3{};
}

/// Returns `m` with columns that are orthonormal to the last bits, so that errors of many products do not add up.
inline Mat3 orthonormal(const Mat3& m) {
  const Vec3 x = normalized(m.column[0]), z = normalized(cross(x, m.column[1]));
  return {{x, cross(z, x), z}};
}

inline Transform movedBy(const Transform& outerFromBody, const Motion& motion) {
  return {orthonormal(rotationBy(turnOf(motion)) * outerFromBody.linear), outerFromBody.offset + shiftOf(motion)};
}

/// Returns the motion that takes `from` to `to`.
inline Motion motionBetween(const Transform& from, const Transform& to) {
  const Vec3 v = to.offset - from.offset, w = rotationVector(to.linear * insonate::transposed(from.linear));
  return {{v.x, v.y, v.z, w.x, w.y, w.z}};
}

}  // namespace insonate::camera
