#pragma once

#include <insonate/image/Volume.h>

#include <array>
#include <string>
#include <vector>

namespace insonate {

/// Parallel slices of one size, each at its own place, in any order.
struct SliceStack {
  int columns = 0, rows = 0;
  std::array<double, 2> spacing_mm{};  ///< along i (between columns), along j (between rows)
  std::array<Vec3, 2> direction;       ///< of i and j; nearly at right angles
  std::vector<Vec3> positions_mm;      ///< center of each slice's first pixel, patient LPS
  double thickness_mm = 0;             ///< 0 when unknown; used as the spacing of a single slice
};

/// Plan by which a stack becomes a volume.
struct StackPlan {
  VolumeGeometry grid;          ///< orthogonal, right-handed
  std::vector<int> order;       ///< slice of the stack at each step along k, ascending
  std::vector<Vec3> offset_mm;  ///< of each slice in that order: its first pixel relative to the grid's, along i, j, k
  bool resample = false;        ///< false: slice n of the order is slice n of the grid
  std::vector<std::string> warnings;
  std::string refusal;
};

/// Positions within this distance are one place.
inline constexpr double kSamePlace_mm = 0.01;
/// Slices further apart than this are not interpolated: a puncture-sized structure could hide between them.
inline constexpr double kLargestFilledGap_mm = 10;

/// Finds spacing, tilt and gaps from the positions alone. The stack has at least one slice and no two at one place.
StackPlan planStack(const SliceStack& stack);

/// Spacing regular enough to need no resampling and no gap.
bool isRegular(const SliceStack& stack);

/// Resamples the slices of `stack` (voxels in the plan's order, kept along k) to the plan's grid: linear within each
/// slice and between neighbors, -1024 HU where a slice that counts for a twentieth or more does not reach.
CtVolume resampleStack(const StackPlan& plan, const SliceStack& stack, const std::vector<std::int16_t>& slices);

}  // namespace insonate
