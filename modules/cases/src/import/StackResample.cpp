#include "../files/Hounsfield.h"
#include "StackPlan.h"

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

/// A cell of one axis: the sample below and the weight of the one above.
struct Cell {
  int low = 0;
  double fraction = 0;
  bool inside = false;
};

Cell cellOf(double index, int size) {
  constexpr double kRounding = 1e-6;
  if (index < -kRounding || index > size - 1 + kRounding) return {};
  const double clamped = std::clamp(index, 0.0, size - 1.0);
  const int low = std::min(static_cast<int>(clamped), std::max(size - 2, 0));
  return {low, clamped - low, true};
}

/// A plane of the grid, to which slices are added.
struct Plane {
  explicit Plane(std::size_t size) : sum(size), weight(size) {}

  std::int16_t hu(std::size_t n) const {
    // A shift of a twentieth of the spacing is invisible (see planStack), so that rounding must not cut off the edge of
    // a slice.
    constexpr double kEnough = 0.95;
    return static_cast<std::int16_t>(weight[n] < kEnough ? kAirHu : std::lround(sum[n] / weight[n]));
  }

  std::vector<double> sum, weight;  ///< of the slices that contribute to each place
};

/// Adds weight * (slice shifted by its offset), within the slice.
void addSlice(const StackPlan& plan, const SliceStack& stack, const std::int16_t* slice, Vec3 offset_mm, double weight,
              Plane& plane) {
  std::vector<Cell> columns(plan.grid.size[0]);
  for (int i = 0; i < plan.grid.size[0]; ++i) columns[i] = cellOf(i - offset_mm.x / stack.spacing_mm[0], stack.columns);
  for (int j = 0; j < plan.grid.size[1]; ++j) {
    const Cell y = cellOf(j - offset_mm.y / stack.spacing_mm[1], stack.rows);
    if (!y.inside) continue;
    const std::size_t row = static_cast<std::size_t>(j) * plan.grid.size[0];
    const std::int16_t* low = slice + static_cast<std::size_t>(y.low) * stack.columns;
    const std::int16_t* high = y.low + 1 < stack.rows ? low + stack.columns : low;
    for (int i = 0; i < plan.grid.size[0]; ++i) {
      const Cell x = columns[i];
      if (!x.inside) continue;
      const int right = std::min(x.low + 1, stack.columns - 1);
      const double upper = low[x.low] * (1 - x.fraction) + low[right] * x.fraction;
      const double lower = high[x.low] * (1 - x.fraction) + high[right] * x.fraction;
      plane.sum[row + i] += weight * (upper * (1 - y.fraction) + lower * y.fraction);
      plane.weight[row + i] += weight;
    }
  }
}

/// The cell that contains depth z among unevenly spaced slices.
Cell sliceCell(const std::vector<Vec3>& offset_mm, double z_mm) {
  const auto above = std::ranges::upper_bound(offset_mm, z_mm, {}, &Vec3::z);
  const int last = static_cast<int>(offset_mm.size()) - 1;
  const int low = std::clamp(static_cast<int>(above - offset_mm.begin()) - 1, 0, std::max(last - 1, 0));
  if (last == 0) return {0, 0, true};
  const double width_mm = offset_mm[low + 1].z - offset_mm[low].z;
  return {low, std::clamp((z_mm - offset_mm[low].z) / width_mm, 0.0, 1.0), true};
}

}  // namespace

CtVolume resampleStack(const StackPlan& plan, const SliceStack& stack, const std::vector<std::int16_t>& slices) {
  CtVolume ct(plan.grid, kAirHu);
  const std::size_t sliceSize = static_cast<std::size_t>(stack.columns) * stack.rows;
  const std::size_t planeSize = static_cast<std::size_t>(plan.grid.size[0]) * plan.grid.size[1];
  for (int k = 0; k < plan.grid.size[2]; ++k) {
    const Cell z = sliceCell(plan.offset_mm, k * plan.grid.spacing_mm.z);
    Plane plane(planeSize);
    for (int side = 0; side < 2; ++side) {
      const double weight = side ? z.fraction : 1 - z.fraction;
      if (weight < 1e-6) continue;
      addSlice(plan, stack, &slices[(z.low + side) * sliceSize], plan.offset_mm[z.low + side], weight, plane);
    }
    for (std::size_t n = 0; n < planeSize; ++n) ct.voxels[k * planeSize + n] = plane.hu(n);
  }
  return ct;
}

}  // namespace insonate
