#pragma once

#include <insonate/ultrasound/FovFit.h>

#include <opencv2/core.hpp>

#include <optional>
#include <vector>

namespace insonate::fit {

/// Outermost points of the body (the bright ultrasound image in a picture) in each row and each column.
struct Contour {
  std::vector<PixelPoint> left, right, top, bottom;
};
/// Finds the contour of a body. Points at the edge of the picture are left out, since the picture ends there and not
/// the body.
Contour contourOf(const cv::Mat_<uchar>& body);

/// A straight line through the point `through` along the unit vector `along`, which points down.
struct Line {
  PixelPoint through, along;
};
std::optional<PixelPoint> crossing(const Line& a, const Line& b);

/// Finds lines on which many points lie and beyond which few lie, the best first. `outward` is -1 if "beyond" means to
/// the left of the line, 1 if to the right.
std::vector<Line> linesThrough(std::vector<PixelPoint> points, double outward, int most);

struct Circle {
  PixelPoint centre;
  double radius = 0;
};
/// Finds circles on whose lowest part many points lie, the best first.
std::vector<Circle> circlesThrough(std::vector<PixelPoint> points, double leastRadius, double mostRadius, int most);

/// Finds the values near which most of the input values lie, the best first: centers of windows of this width.
std::vector<double> modesOf(std::vector<double> values, double width, int most);
/// Returns the quantile of the values for a `share` of 0 to 1; 0 if there are no values.
double quantile(std::vector<double> values, double share);

}  // namespace insonate::fit
