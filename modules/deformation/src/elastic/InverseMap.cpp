#include "elastic/InverseMap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace insonate::elastic {
namespace {

constexpr float kNone = std::numeric_limits<float>::max();

struct Corner {
  float x, z;            // present position
  float shiftX, shiftZ;  // rest position minus present position
};

/// Linear shifts over a triangle, at the lattice points inside it.
void fillTriangle(const Corner& a, const Corner& b, const Corner& c, PlaneDisplacement& out) {
  const float det = (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
  if (det < 1e-9f) return;
  const float step = static_cast<float>(out.step_mm);
  const float left = static_cast<float>(out.left_mm), top = static_cast<float>(out.top_mm);
  constexpr float kTolerance = 1e-4f;
  // Barycentric coordinates u, v of a point are linear in its place relative to corner a.
  const float scale = 1 / det;
  const float uByX = (c.z - a.z) * scale, uByZ = (a.x - c.x) * scale;
  const float vByX = (a.z - b.z) * scale, vByZ = (b.x - a.x) * scale;
  const int firstRow = std::max(0, static_cast<int>(std::ceil((std::min({a.z, b.z, c.z}) - top) / step - kTolerance)));
  const int lastRow =
      std::min(out.rows - 1, static_cast<int>(std::floor((std::max({a.z, b.z, c.z}) - top) / step + kTolerance)));
  const int firstColumn =
      std::max(0, static_cast<int>(std::ceil((std::min({a.x, b.x, c.x}) - left) / step - kTolerance)));
  const int lastColumn =
      std::min(out.columns - 1, static_cast<int>(std::floor((std::max({a.x, b.x, c.x}) - left) / step + kTolerance)));
  for (int r = firstRow; r <= lastRow; ++r)
    for (int k = firstColumn; k <= lastColumn; ++k) {
      const float x = left + k * step - a.x, z = top + r * step - a.z;
      const float u = x * uByX + z * uByZ, v = x * vByX + z * vByZ;
      if (u < -kTolerance || v < -kTolerance || u + v > 1 + kTolerance) continue;
      out.restFromDisplayed[std::size_t(r) * out.columns + k] = {
          a.shiftX + u * (b.shiftX - a.shiftX) + v * (c.shiftX - a.shiftX),
          a.shiftZ + u * (b.shiftZ - a.shiftZ) + v * (c.shiftZ - a.shiftZ)};
    }
}

/// Points that no cell covers, above the skin and beyond the mesh, get the shift of the nearest point below, else
/// above.
void fillRest(PlaneDisplacement& out) {
  for (int k = 0; k < out.columns; ++k) {
    PlaneDisplacement::Shift last{};
    for (int pass = 0; pass < 2; ++pass)
      for (int i = 0; i < out.rows; ++i) {
        auto& here = out.restFromDisplayed[std::size_t(pass == 0 ? out.rows - 1 - i : i) * out.columns + k];
        if (here.x_mm != kNone)
          last = here;
        else if (i > 0)
          here = last;
      }
    if (auto& bottom = out.restFromDisplayed[std::size_t(out.rows - 1) * out.columns + k]; bottom.x_mm == kNone)
      bottom = last;
  }
}

/// In sharply folded tissue, single lattice points may lie on the wrong side of others: they get the mean of their
/// neighbors until none does.
bool unfold(PlaneDisplacement& out, std::vector<int>& folded) {
  constexpr int kMaxRounds = 200;
  const int nx = out.columns;
  // Room for the largest number of them, so that no later frame allocates.
  folded.reserve(4 * out.restFromDisplayed.size());
  const auto step = static_cast<float>(out.step_mm);
  const auto turned = [&](const PlaneDisplacement::Shift* at) {
    const auto &a = at[0], &b = at[1], &c = at[nx], &d = at[nx + 1];
    const float topX = step + b.x_mm - a.x_mm, topZ = b.z_mm - a.z_mm;
    const float bottomX = step + d.x_mm - c.x_mm, bottomZ = d.z_mm - c.z_mm;
    const float leftX = c.x_mm - a.x_mm, leftZ = step + c.z_mm - a.z_mm;
    const float rightX = d.x_mm - b.x_mm, rightZ = step + d.z_mm - b.z_mm;
    return topX * leftZ <= topZ * leftX || topX * rightZ <= topZ * rightX || bottomX * leftZ <= bottomZ * leftX ||
           bottomX * rightZ <= bottomZ * rightX;
  };
  for (int round = 0; round < kMaxRounds; ++round) {
    folded.clear();
    for (int r = 0; r + 1 < out.rows; ++r)
      for (int c = 0; c + 1 < nx; ++c)
        if (const int k = r * nx + c; turned(&out.restFromDisplayed[k]))
          folded.insert(folded.end(), {k, k + 1, k + nx, k + nx + 1});
    if (folded.empty()) return true;
    for (const int k : folded) {
      const int c = k % nx, r = k / nx;
      const auto* at = &out.restFromDisplayed[k];
      const auto &left = at[c > 0 ? -1 : 0], &right = at[c + 1 < nx ? 1 : 0];
      const auto &above = at[r > 0 ? -nx : 0], &below = at[r + 1 < out.rows ? nx : 0];
      out.restFromDisplayed[k] = {(left.x_mm + right.x_mm + above.x_mm + below.x_mm) / 4,
                                  (left.z_mm + right.z_mm + above.z_mm + below.z_mm) / 4};
    }
  }
  return false;
}

}  // namespace

bool invertMesh(const Mesh& mesh, const Nodes& now, const InverseMapExtent& extent, std::vector<int>& folded,
                PlaneDisplacement& out) {
  out.step_mm = extent.step_mm;
  out.left_mm = -extent.half_mm;
  out.top_mm = extent.top_mm;
  out.columns = static_cast<int>(std::lround(2 * extent.half_mm / extent.step_mm)) + 1;
  out.rows = static_cast<int>(std::lround((extent.bottom_mm - extent.top_mm) / extent.step_mm)) + 1;
  out.restFromDisplayed.assign(std::size_t(out.columns) * out.rows, {kNone, 0});
  const Nodes& rest = mesh.rest();
  const int nx = mesh.columns();
  const auto corner = [&](std::size_t n) {
    return Corner{now.x[n], now.z[n], rest.x[n] - now.x[n], rest.z[n] - now.z[n]};
  };
  for (int j = 0; j + 1 < mesh.rows(); ++j)
    for (int i = 0; i + 1 < nx; ++i) {
      const std::size_t n = std::size_t(j) * nx + i;
      const Corner a = corner(n), b = corner(n + 1), c = corner(n + 1 + nx), d = corner(n + nx);
      // The diagonal with which both triangles have the right orientation.
      if ((b.x - a.x) * (c.z - a.z) > (b.z - a.z) * (c.x - a.x) &&
          (c.x - a.x) * (d.z - a.z) > (c.z - a.z) * (d.x - a.x)) {
        fillTriangle(a, b, c, out);
        fillTriangle(a, c, d, out);
      } else {
        fillTriangle(a, b, d, out);
        fillTriangle(b, c, d, out);
      }
    }
  fillRest(out);
  return unfold(out, folded);
}

}  // namespace insonate::elastic
