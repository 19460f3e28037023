#include <insonate/haptics/SimulatedHand.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace insonate {
namespace {

/// The rotation nearest to a blend of two: its columns made orthogonal again.
Mat3 squared(const Mat3& m) {
  const Vec3 z = normalized(m.column[2]);
  const Vec3 y = normalized(cross(z, m.column[0]));
  return {{cross(y, z), y, z}};
}

Result<HandPath::Point> pointOf(const std::string& line, int number) {
  std::vector<double> values;
  std::istringstream fields(line);
  std::string field;
  while (std::getline(fields, field, ',')) {
    std::size_t used = 0;
    double value = 0;
    try {
      value = std::stod(field, &used);
    } catch (const std::exception&) {
      used = 0;
    }
    if (used == 0 || field.find_first_not_of(" \t\r", used) != std::string::npos || !std::isfinite(value))
      return fail("Line " + std::to_string(number) + ": '" + field + "' is not a number.");
    values.push_back(value);
  }
  if (values.size() != 4 && values.size() != 13)
    return fail("Line " + std::to_string(number) + " has " + std::to_string(values.size()) +
                " numbers; time_s,x_mm,y_mm,z_mm are needed, and nine direction cosines may follow.");
  HandPath::Point point{values[0], {values[1], values[2], values[3]}, {}};
  if (values.size() == 4) return point;
  for (int c = 0; c < 3; ++c) point.attitude.column[c] = {values[4 + 3 * c], values[5 + 3 * c], values[6 + 3 * c]};
  const Mat3 product = transposed(point.attitude) * point.attitude;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      if (std::abs(product.column[c][r] - (c == r)) > 1e-3)
        return fail("Line " + std::to_string(number) + ": the nine direction cosines are not a rotation.");
  return point;
}

}  // namespace

HandPath::Point HandPath::at(double time_s) const {
  if (points.empty()) return {time_s, {}, {}};
  const auto next = std::upper_bound(points.begin(), points.end(), time_s,
                                     [](double t, const Point& point) { return t < point.time_s; });
  if (next == points.begin()) return points.front();
  if (next == points.end()) return points.back();
  const Point &a = *(next - 1), &b = *next;
  const double share = (time_s - a.time_s) / (b.time_s - a.time_s);
  Point between{time_s, a.position_mm + (b.position_mm - a.position_mm) * share, a.attitude};
  for (int c = 0; c < 3; ++c)
    between.attitude.column[c] = a.attitude.column[c] * (1 - share) + b.attitude.column[c] * share;
  between.attitude = squared(between.attitude);
  return between;
}

Result<HandPath> parseHandPath(std::string_view text) {
  HandPath path;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#') continue;
    const auto point = pointOf(line, number);
    if (!point) return tl::unexpected(point.error());
    if (!path.points.empty() && point->time_s <= path.points.back().time_s)
      return fail("Line " + std::to_string(number) + ": the times must increase from line to line.");
    path.points.push_back(*point);
  }
  if (path.points.empty()) return fail("This path has no points; each line is time_s,x_mm,y_mm,z_mm.");
  return path;
}

std::string textOf(const HandPath& path) {
  std::string text = "# time_s,x_mm,y_mm,z_mm, columns of the stylus's rotation\n";
  for (const HandPath::Point& p : path.points) {
    char line[400];
    const auto& c = p.attitude.column;
    std::snprintf(line, sizeof line, "%.6f,%.4f,%.4f,%.4f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f\n", p.time_s,
                  p.position_mm.x, p.position_mm.y, p.position_mm.z, c[0].x, c[0].y, c[0].z, c[1].x, c[1].y, c[1].z,
                  c[2].x, c[2].y, c[2].z);
    text += line;
  }
  return text;
}

}  // namespace insonate
