#include "Rotation.h"

#include <cmath>
#include <numbers>

namespace insonate::haptics {

Mat3 rotationOf(const std::array<double, 4>& q) noexcept {
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (!(length > 0.1)) return {};
  const double w = q[0] / length, x = q[1] / length, y = q[2] / length, z = q[3] / length;
  return {{Vec3{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
           Vec3{2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
           Vec3{2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}}};
}

std::array<double, 4> quaternionOf(const Mat3& rotation) noexcept {
  const Vec3 turn = turnOf(rotation);
  const double angle = norm(turn);
  const Vec3 part = angle > 0 ? turn * (std::sin(angle / 2) / angle) : Vec3{};
  return {std::cos(angle / 2), part.x, part.y, part.z};
}

Mat3 turned(const Mat3& by, Vec3 turn_rad) noexcept {
  const double angle = norm(turn_rad);
  if (!(angle > 0)) return by;
  const Vec3 axis = turn_rad / angle;
  Mat3 result;
  for (std::size_t i = 0; i < 3; ++i) {  // formula of Rodrigues
    const Vec3 v = by.column[i];
    result.column[i] =
        v * std::cos(angle) + cross(axis, v) * std::sin(angle) + axis * (dot(axis, v) * (1 - std::cos(angle)));
  }
  const Vec3 x = normalized(result.column[0]);
  const Vec3 y = normalized(result.column[1] - x * dot(x, result.column[1]));
  return {{x, y, cross(x, y)}};
}

Vec3 turnOf(const Mat3& r) noexcept {
  const auto& c = r.column;
  const Vec3 twist{c[1].z - c[2].y, c[2].x - c[0].z, c[0].y - c[1].x};  // 2 sin(angle) times the axis
  const double sine = norm(twist) / 2, cosine = (c[0].x + c[1].y + c[2].z - 1) / 2;
  const double angle = std::atan2(sine, cosine);
  if (sine > 1e-6) return twist * (angle / (2 * sine));
  if (cosine > 0) return twist / 2;
  // Half a turn: the axis is the longest column of r + 1.
  Vec3 axis;
  for (int i = 0; i < 3; ++i) {
    Vec3 v = c[static_cast<std::size_t>(i)];
    v[i] += 1;
    if (norm(v) > norm(axis)) axis = v;
  }
  return normalized(axis) * std::numbers::pi;
}

}  // namespace insonate::haptics
