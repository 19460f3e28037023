#include "Guesses.h"

#include "Contour.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate::fit {
namespace {

constexpr double kMostTurn = 8 * std::numbers::pi / 180;
constexpr double kParallel = 7 * std::numbers::pi / 180;  // sides with a smaller angle belong to a rectangle
constexpr double kLeastHalf = 4 * std::numbers::pi / 180, kMostHalf = 1.35;
constexpr int kLines = 4, kCircles = 3;
constexpr double kFew = 0.01;  // quantile that replaces the outermost point

/// A subset of the textured pixels, for extents.
std::vector<PixelPoint> pointsOf(const cv::Mat_<uchar>& body) {
  std::vector<PixelPoint> points;
  for (int row = 2; row < body.rows; row += 5)
    for (int column = 2; column < body.cols; column += 5)
      if (body(row, column)) points.push_back({double(column), double(row)});
  return points;
}

template <class Of>
std::vector<double> valuesOf(const std::vector<PixelPoint>& points, const Of& of) {
  std::vector<double> values;
  values.reserve(points.size());
  for (const PixelPoint& p : points) values.push_back(of(p));
  return values;
}

void fansFrom(PixelPoint apex, const Contour& contour, const std::vector<PixelPoint>& body,
              std::vector<FovModel>& guesses) {
  const auto angle = [&](PixelPoint p) { return std::atan2(p.x - apex.x, p.y - apex.y); };
  const auto radius = [&](PixelPoint p) { return std::hypot(p.x - apex.x, p.y - apex.y); };
  const std::vector<double> angles = valuesOf(body, angle), radii = valuesOf(body, radius);
  const double far = quantile(radii, 1 - kFew);
  if (far < 30) return;
  const double window = 3.0 / far;
  auto lefts = modesOf(valuesOf(contour.left, angle), 2 * window, 2);
  auto rights = modesOf(valuesOf(contour.right, angle), 2 * window, 2);
  lefts.push_back(quantile(angles, kFew)), rights.push_back(quantile(angles, 1 - kFew));
  auto outers = modesOf(valuesOf(contour.bottom, radius), 4, 2);
  outers.push_back(far);
  auto inners = modesOf(valuesOf(contour.top, radius), 4, 2);
  inners.push_back(quantile(radii, kFew / 4)), inners.push_back(0);
  // If one side is hidden, the fan is assumed upright.
  const std::size_t seenLefts = lefts.size() - 1, seenRights = rights.size() - 1;
  const auto add = [&](double left, double right) {
    const double half = 0.5 * (right - left), turn = 0.5 * (right + left);
    if (half < kLeastHalf || half > kMostHalf || std::abs(turn) > kMostTurn) return;
    for (const double outer : outers)
      for (const double inner : inners)
        if (inner < 0.9 * outer) guesses.push_back({true, apex.x, apex.y, turn, half, inner, outer});
  };
  for (const double left : lefts)
    for (const double right : rights) add(left, right);
  for (std::size_t k = 0; k < seenLefts; ++k) add(lefts[k], -lefts[k]);
  for (std::size_t k = 0; k < seenRights; ++k) add(-rights[k], rights[k]);
}

void rectanglesFrom(double turn, const Contour& contour, const std::vector<PixelPoint>& body,
                    std::vector<FovModel>& guesses) {
  if (std::abs(turn) > kMostTurn) return;
  const double c = std::cos(turn), s = std::sin(turn);
  const auto across = [&](PixelPoint p) { return c * p.x - s * p.y; };
  const auto down = [&](PixelPoint p) { return s * p.x + c * p.y; };
  const auto ends = [&](const std::vector<PixelPoint>& contourSide, const auto& of, double share) {
    auto values = modesOf(valuesOf(contourSide, of), 3, 2);
    values.push_back(quantile(valuesOf(body, of), share));
    return values;
  };
  const auto lefts = ends(contour.left, across, kFew / 4), rights = ends(contour.right, across, 1 - kFew / 4);
  const auto tops = ends(contour.top, down, kFew / 4), bottoms = ends(contour.bottom, down, 1 - kFew / 4);
  for (const double left : lefts)
    for (const double right : rights)
      for (const double top : tops)
        for (const double bottom : bottoms) {
          if (right - left < 30 || bottom - top < 30) continue;
          const double u = 0.5 * (left + right);
          guesses.push_back({false, c * u + s * top, -s * u + c * top, turn, 0.5 * (right - left), 0, bottom - top});
        }
}

double slopeOf(const Line& line) {
  return std::atan2(line.along.x, line.along.y);
}

}  // namespace

std::vector<FovModel> guessesFor(const Plate& plate) {
  std::vector<FovModel> guesses;
  const Contour contour = contourOf(plate.body);
  const std::vector<PixelPoint> body = pointsOf(plate.body);
  if (body.size() < 50) return guesses;
  const auto lefts = linesThrough(contour.left, -1, kLines), rights = linesThrough(contour.right, 1, kLines);
  const double largest = 3.0 * std::max(plate.body.cols, plate.body.rows);
  for (const Line& left : lefts)
    for (const Line& right : rights) {
      const double opening = slopeOf(right) - slopeOf(left);
      if (std::abs(opening) < kParallel)
        rectanglesFrom(0.5 * (slopeOf(left) + slopeOf(right)), contour, body, guesses);
      else if (const auto apex = crossing(left, right); apex && opening > 0)
        fansFrom(*apex, contour, body, guesses);
    }
  for (const Circle& circle : circlesThrough(contour.bottom, 40, largest, kCircles))
    fansFrom(circle.centre, contour, body, guesses);
  for (const Circle& circle : circlesThrough(contour.top, 15, largest, kCircles))
    fansFrom(circle.centre, contour, body, guesses);
  rectanglesFrom(0, contour, body, guesses);
  for (const auto& sides : {lefts, rights})
    for (const Line& side : sides) rectanglesFrom(slopeOf(side), contour, body, guesses);
  return guesses;
}

}  // namespace insonate::fit
