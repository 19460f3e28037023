#include "Contour.h"

#include <algorithm>
#include <cmath>

namespace insonate::fit {
namespace {

constexpr int kTrials = 300;
constexpr double kOnLine_px = 2.0, kOnCircle_px = 2.5;
constexpr std::size_t kFewest = 12;
constexpr double kMostSlope = 4.0;  // slope of the sides: half angles up to 76 degrees
constexpr int kRim_px = 4;

/// Whole numbers below `count`, the same on every machine.
class Draw {
 public:
  std::size_t below(std::size_t count) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return std::size_t((state_ >> 33) % count);
  }

 private:
  std::uint64_t state_ = 20;
};

template <class OnIt>
void removeIf(std::vector<PixelPoint>& points, const OnIt& onIt) {
  points.erase(std::remove_if(points.begin(), points.end(), onIt), points.end());
}

double beside(const Line& line, PixelPoint p) {
  return (p.x - line.through.x) * line.along.y - (p.y - line.through.y) * line.along.x;
}

std::optional<Circle> circleOf(PixelPoint a, PixelPoint b, PixelPoint c) {
  const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const double twice = 2 * (bx * cy - by * cx);
  if (std::abs(twice) < 1e-6) return std::nullopt;
  const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const double ux = (cy * b2 - by * c2) / twice, uy = (bx * c2 - cx * b2) / twice;
  return Circle{{a.x + ux, a.y + uy}, std::hypot(ux, uy)};
}

}  // namespace

Contour contourOf(const cv::Mat_<uchar>& body) {
  Contour contour;
  const int wide = body.cols, high = body.rows;
  const auto keep = [&](std::vector<PixelPoint>& points, int column, int row) {
    if (column >= kRim_px && row >= kRim_px && column < wide - kRim_px && row < high - kRim_px)
      points.push_back({double(column), double(row)});
  };
  for (int row = 0; row < high; ++row) {
    int first = 0, last = wide - 1;
    while (first < wide && !body(row, first)) ++first;
    if (first == wide) continue;
    while (!body(row, last)) --last;
    keep(contour.left, first, row);
    keep(contour.right, last, row);
  }
  for (int column = 0; column < wide; ++column) {
    int first = 0, last = high - 1;
    while (first < high && !body(first, column)) ++first;
    if (first == high) continue;
    while (!body(last, column)) --last;
    keep(contour.top, column, first);
    keep(contour.bottom, column, last);
  }
  return contour;
}

std::optional<PixelPoint> crossing(const Line& a, const Line& b) {
  const double det = a.along.x * b.along.y - a.along.y * b.along.x;
  if (std::abs(det) < 1e-9) return std::nullopt;
  const double dx = b.through.x - a.through.x, dy = b.through.y - a.through.y;
  const double t = (dx * b.along.y - dy * b.along.x) / det;
  return PixelPoint{a.through.x + t * a.along.x, a.through.y + t * a.along.y};
}

std::vector<Line> linesThrough(std::vector<PixelPoint> points, double outward, int most) {
  const std::vector<PixelPoint> all = points;
  std::vector<Line> lines;
  Draw draw;
  while (int(lines.size()) < most && points.size() > kFewest) {
    Line best;
    double bestScore = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
      const PixelPoint a = points[draw.below(points.size())], b = points[draw.below(points.size())];
      const double dy = b.y - a.y, dx = b.x - a.x;
      if (std::abs(dy) < 8 || std::abs(dx) > kMostSlope * std::abs(dy)) continue;
      const double length = std::copysign(std::hypot(dx, dy), dy);
      const Line line{a, {dx / length, dy / length}};
      double score = 0;
      for (const PixelPoint& p : points) {
        const double out = outward * beside(line, p);
        score += std::abs(out) < kOnLine_px ? 1.0 : out > 2 * kOnLine_px ? -0.3 : 0.0;
      }
      if (score > bestScore) bestScore = score, best = line;
    }
    if (bestScore < kFewest) break;
    lines.push_back(best);
    removeIf(points, [&](PixelPoint p) { return std::abs(beside(best, p)) < 2 * kOnLine_px; });
  }
  return lines;
}

std::vector<Circle> circlesThrough(std::vector<PixelPoint> points, double leastRadius, double mostRadius, int most) {
  std::vector<Circle> circles;
  Draw draw;
  while (int(circles.size()) < most && points.size() > 2 * kFewest) {
    Circle best;
    double bestScore = 0;
    for (int trial = 0; trial < 2 * kTrials; ++trial) {
      const auto pick = [&] { return points[draw.below(points.size())]; };
      const auto circle = circleOf(pick(), pick(), pick());
      if (!circle || circle->radius < leastRadius || circle->radius > mostRadius) continue;
      double score = 0;
      for (const PixelPoint& p : points) {
        if (p.y < circle->centre.y) continue;
        const double out = std::hypot(p.x - circle->centre.x, p.y - circle->centre.y) - circle->radius;
        score += std::abs(out) < kOnCircle_px ? 1.0 : 0.0;
      }
      if (score > bestScore) bestScore = score, best = *circle;
    }
    if (bestScore < kFewest) break;
    circles.push_back(best);
    removeIf(points, [&](PixelPoint p) {
      return std::abs(std::hypot(p.x - best.centre.x, p.y - best.centre.y) - best.radius) < 2 * kOnCircle_px;
    });
  }
  return circles;
}

std::vector<double> modesOf(std::vector<double> values, double width, int most) {
  std::vector<double> modes;
  std::sort(values.begin(), values.end());
  while (int(modes.size()) < most && values.size() >= kFewest) {
    std::size_t bestFrom = 0, bestTo = 0;
    for (std::size_t from = 0, to = 0; from < values.size(); ++from) {
      while (to < values.size() && values[to] <= values[from] + width) ++to;
      if (to - from > bestTo - bestFrom) bestFrom = from, bestTo = to;
    }
    if (bestTo - bestFrom < kFewest) break;
    const double middle = values[(bestFrom + bestTo) / 2];
    modes.push_back(middle);
    values.erase(std::remove_if(values.begin(), values.end(),
                                [&](double value) { return std::abs(value - middle) < 2 * width; }),
                 values.end());
  }
  return modes;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace insonate::fit
