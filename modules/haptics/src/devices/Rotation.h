#pragma once

#include <insonate/core/Transform.h>

#include <array>

namespace insonate::haptics {

/// Rotation of a quaternion w, x, y, z of any length; empty if it is not a rotation.
Mat3 rotationOf(const std::array<double, 4>& quaternion) noexcept;

/// w, x, y, z of unit length, w not below 0.
std::array<double, 4> quaternionOf(const Mat3& rotation) noexcept;

/// `by`, turned about the frame's axes by the length of `turn_rad`; square again, so that many turns stay one.
Mat3 turned(const Mat3& by, Vec3 turn_rad) noexcept;

/// The turn that `rotation` is: its axis times its angle, at most pi.
Vec3 turnOf(const Mat3& rotation) noexcept;

}  // namespace insonate::haptics
