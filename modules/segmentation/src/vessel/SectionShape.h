#pragma once

#include "ClosedWay.h"

#include <utility>
#include <vector>

namespace insonate::segmentation {

/// Moments of the area inside an outline: its middle, mm, and its second moments about it, mm^2.
struct SectionMoments {
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
};

/// Mean moments of the sections up to `reach` to both sides.
SectionMoments meanMoments(const std::vector<SectionMoments>& sections, int n, int reach);

/// Stretch of a section that makes a flat outline round: a symmetric matrix whose determinant is 1.
class SectionShape {
 public:
  SectionShape() = default;
  /// Stretch of an ellipse with these second moments, no flatter than 1 to 4.
  explicit SectionShape(const SectionMoments& moments);

  /// Displacement in the section, mm, of a millimeter along this ray.
  std::pair<double, double> along(int ray) const;
  /// Moments of the outline with these radii along the stretched rays.
  SectionMoments momentsOf(const Radii& radii) const;
  /// Converts the outline to radii along unstretched rays.
  Radii unstretched(const Radii& radii) const;

 private:
  std::array<std::pair<double, double>, VesselOutline::kRays> corners(const Radii& radii) const;

  double xx_ = 1, xy_ = 0, yy_ = 1;
};

}  // namespace insonate::segmentation
