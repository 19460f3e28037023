#pragma once

#include "ClosedWay.h"

#include <utility>
#include <vector>

namespace insonate::segmentation {

/// Moments of the area within an outline: its centroid, mm, and its second moments about the centroid, mm^2.
struct SectionMoments {
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
};

/// Returns the mean moments of section n and up to `reach` sections on both sides.
SectionMoments meanMoments(const std::vector<SectionMoments>& sections, int n, int reach);

/// Linear transform of a section that makes a flat outline round: a symmetric matrix with determinant 1.
class SectionShape {
 public:
  SectionShape() = default;
  /// Computes the transform that makes the ellipse with these second moments round; the axis ratio is limited to 1:4.
  explicit SectionShape(const SectionMoments& moments);

  /// Returns the vector in the section, mm, that becomes one millimeter along this ray after the transform.
  std::pair<double, double> along(int ray) const;
  /// Returns the moments of the outline whose radii are measured along the transformed (stretched) rays.
  SectionMoments momentsOf(const Radii& radii) const;
  /// Converts an outline from radii along stretched rays to radii along unstretched rays.
  Radii unstretched(const Radii& radii) const;

 private:
  std::array<std::pair<double, double>, VesselOutline::kRays> corners(const Radii& radii) const;

  double xx_ = 1, xy_ = 0, yy_ = 1;
};

}  // namespace insonate::segmentation
