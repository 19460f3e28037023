#pragma once

#include <insonate/ultrasound/FovFit.h>

#include <opencv2/core.hpp>

#include <optional>
#include <vector>

namespace insonate::fit {

/// The body's outermost points, row by row and column by column.
struct Contour {
  std::vector<PixelPoint> left, right, top, bottom;
};
/// Points at the rim of the image are left out: there the image ends, not the body.
Contour contourOf(const cv::Mat_<uchar>& body);

/// A line through `through` along a unit vector that points down.
struct Line {
  PixelPoint through, along;
};
std::optional<PixelPoint> crossing(const Line& a, const Line& b);

/// Lines that many points lie on and few lie beyond, the best first. `outward` is -1 where beyond is to the left.
std::vector<Line> linesThrough(std::vector<PixelPoint> points, double outward, int most);

struct Circle {
  PixelPoint centre;
  double radius = 0;
};
/// Circles whose lowest part many points lie on, the best first.
std::vector<Circle> circlesThrough(std::vector<PixelPoint> points, double leastRadius, double mostRadius, int most);

/// The values that most of the others lie near, the best first: middles of windows of this width.
std::vector<double> modesOf(std::vector<double> values, double width, int most);
/// Share is 0..1; 0 for no values.
double quantile(std::vector<double> values, double share);

}  // namespace insonate::fit
