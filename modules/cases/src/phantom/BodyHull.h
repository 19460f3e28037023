#pragma once

#include <insonate/image/Volume.h>

#include <vector>

namespace insonate {

/// A smooth, closed body around labeled structures: the convex hull of each axial slice, smoothed from slice to slice
/// and enlarged. Coordinates within a slice are in mm along the grid's first two axes from voxel (0, 0).
class BodyHull {
 public:
  /// Builds the hull of all voxels whose label is not zero, enlarged by `grow_mm` on all sides. At least one voxel must
  /// be labeled.
  BodyHull(const LabelMap& structures, double grow_mm);

  /// Returns the depth below the body's surface (negative outside), mm, to first order. `k` is a slice of the grid.
  double depth_mm(double x_mm, double y_mm, int k) const;

 private:
  static constexpr int kDirections = 180;

  struct Slice {
    double centerX = 0, centerY = 0;
    std::vector<double> support_mm;  ///< maximum distance of the structures from the center, by direction
    std::vector<double> radius_mm;   ///< radius of the hull around the center, by direction
  };
  void measure(const LabelMap& structures);
  void fillGaps();
  void smooth(double sliceSpacing_mm);
  void makeRadii(double grow_mm);

  std::vector<Slice> slices_;
};

}  // namespace insonate
