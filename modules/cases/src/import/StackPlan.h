#pragma once

#include <insonate/image/Volume.h>

#include <array>
#include <string>
#include <vector>

namespace insonate {

/// Parallel slices of one size, in any order, each at a different position.
struct SliceStack {
  int columns = 0, rows = 0;
  std::array<double, 2> spacing_mm{};  ///< distance between pixels along i (between columns) and along j (between rows)
  std::array<Vec3, 2> direction;  ///< patient directions of i (along a row) and j (down a column); nearly perpendicular
  std::vector<Vec3> positions_mm;  ///< center of each slice's first pixel, patient LPS
  double thickness_mm = 0;         ///< slice thickness, used as the spacing of a single slice; 0 if unknown
};

/// Grid and order in which a stack becomes a volume.
struct StackPlan {
  VolumeGeometry grid;          ///< grid of the volume: orthogonal, right-handed
  std::vector<int> order;       ///< indices of slices in the stack, by increasing k
  std::vector<Vec3> offset_mm;  ///< offset of each ordered slice's first pixel from the grid's origin, along i, j, k
  bool resample = false;  ///< true if slices must be interpolated; false if slice n of `order` is slice n of the grid
  std::vector<std::string> warnings;
  std::string refusal;
};

/// Maximum distance of two positions that are regarded as equal.
inline constexpr double kSamePlace_mm = 0.01;
/// Maximum distance of slices between which values are interpolated: a structure the size of a vessel could lie unseen
/// in a larger gap.
inline constexpr double kLargestFilledGap_mm = 10;

/// Determines a stack's spacing, tilt and gaps from the positions of its slices alone. The stack must have at least one
/// slice, and no two at the same position.
StackPlan planStack(const SliceStack& stack);

/// Tells whether the slices are spaced evenly enough: without gaps, and without need for resampling along k.
bool isRegular(const SliceStack& stack);

/// Tells whether the slices are one evenly spaced run on a straight line, in which up to a tenth of the slices may be
/// missing.
bool isRun(const SliceStack& stack);

/// Resamples the slices of `stack` to the plan's grid. `slices` holds the voxels in the plan's order. Interpolates
/// linearly within each slice and between neighboring slices; a voxel is -1024 HU if a slice with a weight of a
/// twentieth or more does not cover it.
CtVolume resampleStack(const StackPlan& plan, const SliceStack& stack, const std::vector<std::int16_t>& slices);

}  // namespace insonate
