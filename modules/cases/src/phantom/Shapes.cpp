#include "Shapes.h"

#include "Noise.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace insonate::phantom {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
/// Shapes are asked this far outside their boundary: for sheaths and for the gaps between muscles.
constexpr double kReach_mm = 3.5;

/// Boundary noise with two scales, so that no outline is an ellipse.
double irregular(double distance_mm, Vec3 p_mm, double amplitude_mm, std::uint32_t seed) {
  if (amplitude_mm == 0 || distance_mm > kReach_mm + 1.4 * amplitude_mm) return distance_mm;
  return distance_mm +
         amplitude_mm * (smoothNoise(p_mm / 7.0, seed) + 0.4 * smoothNoise(p_mm / 2.9, seed ^ 0x9e3779b9U));
}

/// Implicit ellipse divided by the length of its gradient: exact on the boundary to first order.
double ellipseDistance(double u, double v, double a, double b) {
  const double q = std::sqrt(u * u / (a * a) + v * v / (b * b));
  const double gradient = std::sqrt(u * u / (a * a * a * a) + v * v / (b * b * b * b));
  return gradient > 1e-9 ? q * (q - 1) / gradient : -std::min(a, b);
}

/// Scale of a cross-section so that the ends of a column are half ellipsoids.
double rounding(double z_mm, double first_mm, double last_mm, double taper_mm) {
  const double fromEnd = std::min(z_mm - first_mm, last_mm - z_mm);
  if (fromEnd <= 0) return 0;
  if (fromEnd >= taper_mm) return 1;
  const double t = 1 - fromEnd / taper_mm;
  return std::sqrt(1 - t * t);
}

Box2 around(Side side, double lateral_mm, double y_mm, double reachX_mm, double reachY_mm) {
  const double x = patientX(side, lateral_mm);
  return {x - reachX_mm, x + reachX_mm, y_mm - reachY_mm, y_mm + reachY_mm};
}

void enclose(Box2& box, const Box2& other) {
  box = {std::min(box.minX, other.minX), std::max(box.maxX, other.maxX), std::min(box.minY, other.minY),
         std::max(box.maxY, other.maxY)};
}

bool holds(const Box2& box, Vec3 p_mm) {
  return p_mm.x >= box.minX && p_mm.x <= box.maxX && p_mm.y >= box.minY && p_mm.y <= box.maxY;
}

}  // namespace

Shape column(Side side, Column c, std::uint32_t seed) {
  return [side, c = std::move(c), seed](const BodySurface::Slice&, double z_mm) -> std::optional<Section> {
    const double scale = rounding(z_mm, c.course.first(), c.course.last(), c.taper_mm);
    if (scale <= 0) return std::nullopt;
    const auto [lateral, y, halfX, halfY, turn] = c.course(z_mm);
    const double a = halfX * scale, b = halfY * scale;
    if (a < 0.1 || b < 0.1) return std::nullopt;
    const double ct = std::cos(turn * kDegree), st = std::sin(turn * kDegree);
    const double reachX = std::hypot(a * ct, b * st) + kReach_mm, reachY = std::hypot(a * st, b * ct) + kReach_mm;
    const double rough = std::min(c.irregular_mm, 0.25 * std::min(a, b));
    return Section{around(side, lateral, y, reachX, reachY), [=, l0 = lateral, y0 = y](const Site& s) {
                     const double dx = patientX(side, s.p_mm.x) - l0, dy = s.p_mm.y - y0;
                     const double d = ellipseDistance(dx * ct + dy * st, dy * ct - dx * st, a, b);
                     return irregular(d, s.p_mm, rough, seed);
                   }};
  };
}

Shape sheet(Side side, Sheet c, std::uint32_t seed) {
  return [side, c = std::move(c), seed](const BodySurface::Slice& body, double z_mm) -> std::optional<Section> {
    const double scale = rounding(z_mm, c.course.first(), c.course.last(), c.taper_mm);
    if (scale <= 0) return std::nullopt;
    const auto [angleDegrees, depth, halfWidth, halfThickness] = c.course(z_mm);
    const double a = halfWidth * scale, b = halfThickness * scale;
    if (a < 0.1 || b < 0.1) return std::nullopt;
    const double sign = side == Side::kRight ? 1 : -1, angle0 = angleDegrees * kDegree, depth0 = depth;
    const double arcRadius = body.fasciaRadius_mm(sign * angle0) - depth;
    Box2 box{1e9, -1e9, 1e9, -1e9};
    const double halfAngle = (a + kReach_mm) / arcRadius;
    for (int n = -4; n <= 4; ++n) {
      const double angle = sign * (angle0 + halfAngle * n / 4), r = body.fasciaRadius_mm(angle) - depth;
      const Vec3 at{-r * std::sin(angle), BodySurface::kAxisY_mm - r * std::cos(angle), 0};
      // Slanted surfaces spread depth over a longer radius.
      const double reach = 2.2 * b + kReach_mm + 2;
      enclose(box, {at.x - reach, at.x + reach, at.y - reach, at.y + reach});
    }
    return Section{box, [=, rough = c.irregular_mm](const Site& s) {
                     double turn = sign * s.angle - angle0;
                     if (turn > std::numbers::pi) turn -= 2 * std::numbers::pi;
                     if (turn < -std::numbers::pi) turn += 2 * std::numbers::pi;
                     const double d = ellipseDistance(turn * arcRadius, s.belowFascia_mm - depth0, a, b);
                     return irregular(d, s.p_mm, rough, seed);
                   }};
  };
}

std::vector<Tube::Knot> centreLine(const std::vector<Tube::Knot>& knots) {
  std::vector<Curve<4>::Knot> along;
  double length = 0;
  for (std::size_t n = 0; n < knots.size(); ++n) {
    if (n > 0) length += norm(knots[n].p_mm - knots[n - 1].p_mm);
    along.push_back({length, {knots[n].p_mm.x, knots[n].p_mm.y, knots[n].p_mm.z, knots[n].radius_mm}});
  }
  const Curve<4> curve(along);
  const int steps = std::max(1, static_cast<int>(length / 1.5));
  std::vector<Tube::Knot> line;
  for (int n = 0; n <= steps; ++n) {
    const auto [x, y, z, r] = curve(length * n / steps);
    line.push_back({{x, y, z}, r});
  }
  return line;
}

Shape tube(Side side, Tube t, std::uint32_t seed) {
  const auto line = std::make_shared<const std::vector<Tube::Knot>>(centreLine(t.knots));
  return [=, flatness = t.flatness, rough = t.irregular_mm](const BodySurface::Slice&,
                                                            double z_mm) -> std::optional<Section> {
    struct Piece {
      Vec3 from, along;
      double inverseLength2, radius, widening;
    };
    std::vector<Piece> pieces;
    Box2 box{1e9, -1e9, 1e9, -1e9};
    for (std::size_t n = 0; n + 1 < line->size(); ++n) {
      const auto& [p, r] = (*line)[n];
      const auto& [q, s] = (*line)[n + 1];
      const double reach = std::max(r, s) + kReach_mm;
      const double reachZ = reach / flatness;
      if (std::min(p.z, q.z) - z_mm > reachZ || z_mm - std::max(p.z, q.z) > reachZ) continue;
      const Vec3 from{p.x, p.y, p.z * flatness}, along{q.x - p.x, q.y - p.y, (q.z - p.z) * flatness};
      pieces.push_back({from, along, 1 / std::max(dot(along, along), 1e-9), r, s - r});
      enclose(box, around(side, p.x, p.y, reach, reach));
      enclose(box, around(side, q.x, q.y, reach, reach));
    }
    if (pieces.empty()) return std::nullopt;
    return Section{box, [=, pieces = std::move(pieces)](const Site& s) {
                     const Vec3 p{patientX(side, s.p_mm.x), s.p_mm.y, s.p_mm.z * flatness};
                     double nearest = 1e9;
                     for (const Piece& piece : pieces) {
                       const double t01 = std::clamp(dot(p - piece.from, piece.along) * piece.inverseLength2, 0.0, 1.0);
                       const double d = norm(p - piece.from - piece.along * t01) - piece.radius - piece.widening * t01;
                       nearest = std::min(nearest, d);
                     }
                     return irregular(nearest, s.p_mm, rough, seed);
                   }};
  };
}

Shape join(std::vector<Shape> shapes) {
  return [shapes = std::move(shapes)](const BodySurface::Slice& body, double z_mm) -> std::optional<Section> {
    std::vector<Section> parts;
    Box2 box{1e9, -1e9, 1e9, -1e9};
    for (const Shape& shape : shapes)
      if (auto section = shape(body, z_mm)) {
        enclose(box, section->bounds_mm);
        parts.push_back(std::move(*section));
      }
    if (parts.empty()) return std::nullopt;
    return Section{box, [parts = std::move(parts)](const Site& s) {
                     double nearest = 1e9;
                     for (const Section& part : parts)
                       if (holds(part.bounds_mm, s.p_mm)) nearest = std::min(nearest, part.distance_mm(s));
                     return nearest;
                   }};
  };
}

Shape shell(Shape inner, double from_mm, double to_mm) {
  return [=, inner = std::move(inner)](const BodySurface::Slice& body, double z_mm) -> std::optional<Section> {
    auto section = inner(body, z_mm);
    if (!section) return std::nullopt;
    return Section{section->bounds_mm, [=, distance = std::move(section->distance_mm)](const Site& s) {
                     const double d = distance(s);
                     return std::max(from_mm - d, d - to_mm);
                   }};
  };
}

Shape clip(Shape shape, std::function<double(Vec3)> limit_mm) {
  return [=, shape = std::move(shape)](const BodySurface::Slice& body, double z_mm) -> std::optional<Section> {
    auto section = shape(body, z_mm);
    if (!section) return std::nullopt;
    return Section{section->bounds_mm, [=, distance = std::move(section->distance_mm)](const Site& s) {
                     return std::max(distance(s), limit_mm(s.p_mm));
                   }};
  };
}

}  // namespace insonate::phantom
