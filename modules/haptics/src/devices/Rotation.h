#pragma once

#include <insonate/core/Transform.h>

#include <array>

namespace insonate::haptics {

/// Rotation of a quaternion w, x, y, z of any length; empty if it is not a rotation.
Mat3 rotationOf(const std::array<double, 4>& quaternion) noexcept;

/// Quaternion w, x, y, z of unit length, with w not below 0.
std::array<double, 4> quaternionOf(const Mat3& rotation) noexcept;

/// Returns `by` turned about the axis `turn_rad` (in the frame's axes) by an angle equal to its length. The result is
/// made orthogonal again, so that many turns remain a rotation.
Mat3 turned(const Mat3& by, Vec3 turn_rad) noexcept;

/// Rotation vector of `rotation`: its axis times its angle, at most pi.
Vec3 turnOf(const Mat3& rotation) noexcept;

}  // namespace insonate::haptics
