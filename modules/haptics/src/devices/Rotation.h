#pragma once

#include <insonate/core/Transform.h>

#include <array>

namespace insonate::haptics {

/// Converts a quaternion w, x, y, z of any length to a rotation matrix.
Mat3 rotationOf(const std::array<double, 4>& quaternion) noexcept;

/// Converts a rotation matrix to a unit quaternion w, x, y, z, with w not below 0.
std::array<double, 4> quaternionOf(const Mat3& rotation) noexcept;

/// Returns the rotation `by`, then turned about the axis `turn_rad` by an angle equal to its length. The result is made
/// orthogonal, so that many turns remain a rotation.
Mat3 turned(const Mat3& by, Vec3 turn_rad) noexcept;

/// Returns the rotation vector of `rotation`: its axis times its angle in radians, at most pi.
Vec3 turnOf(const Mat3& rotation) noexcept;

}  // namespace insonate::haptics
