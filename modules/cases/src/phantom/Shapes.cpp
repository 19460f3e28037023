#include "Shapes.h"

#include "Individual.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace insonate::phantom {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
/// Shapes have defined distances up to this far outside their boundary, for sheaths and gaps between muscles.
constexpr double kReach_mm = 3.5;

constexpr double kTendon = 2.5;  ///< a muscle tapers over this multiple of the length of a rounded end

/// Boundary noise with two scales, longer along the neck, as are fibers and vessels.
double irregular(double distance_mm, Vec3 p_mm, double amplitude_mm, std::uint32_t seed) {
  if (amplitude_mm == 0 || distance_mm > kReach_mm + 1.4 * amplitude_mm) return distance_mm;
  const Vec3 at{p_mm.x, p_mm.y, p_mm.z * 0.4};
  return distance_mm + amplitude_mm * (smoothNoise(at / 7.0, seed) + 0.4 * smoothNoise(at / 2.9, seed ^ 0x9e3779b9U));
}

/// Deviation of a cross-section from its ellipse: relative radius as a Fourier series of orders 2 to 4 over the
/// direction, given by its cosine and sine.
struct Lobes {
  double cos2 = 0, sin2 = 0, cos3 = 0, sin3 = 0, cos4 = 0, sin4 = 0;

  double operator()(double c, double s) const {
    const double c2 = c * c - s * s, s2 = 2 * c * s;
    return cos2 * c2 + sin2 * s2 + cos3 * (c2 * c - s2 * s) + sin3 * (s2 * c + c2 * s) + cos4 * (c2 * c2 - s2 * s2) +
           sin4 * 2 * s2 * c2;
  }
};

/// Lobes of about the given size that change their direction slowly along the neck; the second order has the largest
/// weight.
Lobes lobesAt(double z_mm, double amount, std::uint32_t seed) {
  if (amount == 0) return {};
  constexpr double kCell_mm = 24;
  const Individual vary(seed);
  const auto part = [&](std::uint32_t of, double weight) {
    return amount * weight * (0.8 * vary(of) + vary.along(of, z_mm, kCell_mm));
  };
  return {part(2, 1), part(12, 1), part(3, 0.7), part(13, 0.7), part(4, 0.35), part(14, 0.35)};
}

/// Implicit lobed ellipse divided by the length of its gradient: exact on the boundary to first order.
double ovalDistance(double u, double v, double a, double b, const Lobes& lobes) {
  const double c = u / a, s = v / b, q = std::sqrt(c * c + s * s);
  const double gradient = std::sqrt(c * c / (a * a) + s * s / (b * b));
  return gradient > 1e-9 ? q * (q - 1 - lobes(c / q, s / q)) / gradient : -std::min(a, b);
}

/// A lens with sharp edges. Its thickest place is not in its middle and its midline is bent, so that its two faces
/// differ.
struct Lens {
  double halfWidth_mm, halfThickness_mm;
  double skew = 0;  ///< thickest place, relative to the half width
  double bent = 0;  ///< height of the edges above the middle, relative to the half thickness
  double tilt = 0;  ///< difference of depth between the edges, relative to the half thickness

  double distance_mm(double u, double v) const {
    const double t = u / halfWidth_mm, edge = std::clamp(t, -1.0, 1.0);
    const double middle = halfThickness_mm * (tilt * edge - bent * edge * edge);
    if (std::abs(t) >= 1) return std::hypot(u - edge * halfWidth_mm, v - middle);
    const double x = edge - skew * (1 - edge * edge), rest = 1 - x * x;
    const double root = std::sqrt(std::max(0.0, rest)), half = halfThickness_mm * rest * root * (1 + 0.5 * x * x);
    const double slope =
        halfThickness_mm / halfWidth_mm * (std::abs(x) * root * (2 + 2.5 * x * x) + std::abs(tilt - 2 * bent * edge));
    return (std::abs(v - middle) - half) / std::sqrt(1 + slope * slope);
  }
};

Lens lensAt(double z_mm, double halfWidth_mm, double halfThickness_mm, std::uint32_t seed) {
  constexpr double kCell_mm = 30;
  const Individual vary(seed);
  return {halfWidth_mm, halfThickness_mm, 0.16 * vary(1) + 0.12 * vary.along(2, z_mm, kCell_mm),
          0.45 + 0.2 * vary(3) + 0.25 * vary.along(4, z_mm, kCell_mm),
          0.2 * vary(5) + 0.25 * vary.along(6, z_mm, kCell_mm)};
}

/// Scale of a cross-section that makes the ends of a column half ellipsoids.
double rounding(double z_mm, double first_mm, double last_mm, double taper_mm) {
  const double fromEnd = std::min(z_mm - first_mm, last_mm - z_mm);
  if (fromEnd <= 0) return 0;
  if (fromEnd >= taper_mm) return 1;
  const double t = 1 - fromEnd / taper_mm;
  return std::sqrt(1 - t * t);
}

/// Scale of the cross-section of a muscle, which tapers into a tendon.
double tapering(double z_mm, double first_mm, double last_mm, double taper_mm) {
  const double round = rounding(z_mm, first_mm, last_mm, std::min(kTendon * taper_mm, 0.45 * (last_mm - first_mm)));
  return round * round;
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

namespace {

/// Flat toward the three neighbors of a jugular vein, and dented by the first.
struct Facets {
  double flat, dent, towardX, towardY;

  double operator()(double c, double s) const {
    const double along = c * towardX + s * towardY, near = 0.5 + 0.5 * along, near2 = near * near;
    return -flat * along * (4 * along * along - 3) - dent * (near2 * near2 - 0.25);
  }
};

Facets facetsAt(double z_mm, double facing, double a, double b, std::uint32_t seed) {
  constexpr double kCell_mm = 28;
  const Individual vary(seed);
  const double turned = facing + 0.35 * vary(35) + 0.35 * vary.along(36, z_mm, kCell_mm);
  const double x = std::cos(turned) / a, y = std::sin(turned) / b, length = std::hypot(x, y);
  return {0.06 + 0.035 * vary(31) + 0.05 * vary.along(32, z_mm, kCell_mm),
          0.1 + 0.08 * vary(33) + 0.09 * vary.along(34, z_mm, kCell_mm), x / length, y / length};
}

/// Relative size of lobes; large organs have lobes of at most 0.4 mm.
double lobedness(Form form, double a, double b) {
  return form == Form::kBelly ? 0.09 : std::min(0.04, 0.4 / std::max(a, b));
}

/// Distance from the position along both half axes; `facing` is relative to the first.
std::function<double(double u, double v)> sectionOf(Form form, double z_mm, double a, double b, double facing,
                                                    std::uint32_t seed) {
  if (form == Form::kLens)
    return [lens = lensAt(z_mm, a, b, seed)](double u, double v) { return lens.distance_mm(u, v); };
  const Lobes lobes = lobesAt(z_mm, lobedness(form, a, b), seed);
  if (form != Form::kFaceted) return [=](double u, double v) { return ovalDistance(u, v, a, b, lobes); };
  const Facets facets = facetsAt(z_mm, facing, a, b, seed);
  return [=](double u, double v) {
    const double cx = u / a, sx = v / b, q = std::sqrt(cx * cx + sx * sx);
    const double gradient = std::sqrt(cx * cx / (a * a) + sx * sx / (b * b));
    if (gradient <= 1e-9) return -std::min(a, b);
    return q * (q - 1 - lobes(cx / q, sx / q) - facets(cx / q, sx / q)) / gradient;
  };
}

}  // namespace

Shape column(Side side, Column c, std::uint32_t seed) {
  return [side, c = std::move(c), seed](const BodySurface::Slice&, double z_mm) -> std::optional<Section> {
    const bool muscle = c.form == Form::kBelly || c.form == Form::kLens;
    const double scale = (muscle ? tapering : rounding)(z_mm, c.course.first(), c.course.last(), c.taper_mm);
    if (scale <= 0) return std::nullopt;
    const auto [lateral, y, halfX, halfY, turn] = c.course(z_mm);
    const double a = halfX * scale, b = halfY * scale;
    if (a < 0.1 || b < 0.1) return std::nullopt;
    const double ct = std::cos(turn * kDegree), st = std::sin(turn * kDegree);
    const double reachX = 1.2 * std::hypot(a * ct, b * st) + kReach_mm;
    const double reachY = 1.2 * std::hypot(a * st, b * ct) + kReach_mm;
    const double rough = std::min(c.irregular_mm, 0.25 * std::min(a, b));
    const auto section = sectionOf(c.form, z_mm, a, b, (c.facing_deg - turn) * kDegree, seed ^ 0x10beU);
    return Section{around(side, lateral, y, reachX, reachY), [=, l0 = lateral, y0 = y](const Site& s) {
                     const double dx = patientX(side, s.p_mm.x) - l0, dy = s.p_mm.y - y0;
                     return irregular(section(dx * ct + dy * st, dy * ct - dx * st), s.p_mm, rough, seed);
                   }};
  };
}

Shape sheet(Side side, Sheet c, std::uint32_t seed) {
  return [side, c = std::move(c), seed](const BodySurface::Slice& body, double z_mm) -> std::optional<Section> {
    const double scale = tapering(z_mm, c.course.first(), c.course.last(), c.taper_mm);
    if (scale <= 0) return std::nullopt;
    const auto [angleDegrees, depth, halfWidth, halfThickness] = c.course(z_mm);
    const bool flat = c.form == Form::kLens;
    const double a = halfWidth * (flat ? 0.4 + 0.6 * scale : scale), b = halfThickness * scale;
    if (b < 0.1) return std::nullopt;
    const double sign = side == Side::kRight ? 1 : -1, angle0 = angleDegrees * kDegree, depth0 = depth;
    const double arcRadius = body.fasciaRadius_mm(sign * angle0) - depth;
    Box2 box{1e9, -1e9, 1e9, -1e9};
    const double halfAngle = (a + kReach_mm) / arcRadius;
    for (int n = -4; n <= 4; ++n) {
      const double angle = sign * (angle0 + halfAngle * n / 4), r = body.fasciaRadius_mm(angle) - depth;
      const Vec3 at{-r * std::sin(angle), BodySurface::kAxisY_mm - r * std::cos(angle), 0};
      // On slanted surfaces depth is distributed over a longer radius.
      const double reach = 2.2 * b + kReach_mm + 2;
      enclose(box, {at.x - reach, at.x + reach, at.y - reach, at.y + reach});
    }
    const auto section = sectionOf(c.form, z_mm, a, b, 0, seed ^ 0x1e25U);
    const double rough = std::min(c.irregular_mm, 0.3 * b);
    return Section{box, [=](const Site& s) {
                     double turn = sign * s.angle - angle0;
                     if (turn > std::numbers::pi) turn -= 2 * std::numbers::pi;
                     if (turn < -std::numbers::pi) turn += 2 * std::numbers::pi;
                     return irregular(section(turn * arcRadius, s.belowFascia_mm - depth0), s.p_mm, rough, seed);
                   }};
  };
}

std::vector<Tube::Knot> centerLine(const std::vector<Tube::Knot>& knots) {
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
  const auto line = std::make_shared<const std::vector<Tube::Knot>>(centerLine(t.knots));
  return [=, flatness = t.flatness, rough = t.irregular_mm, oval = t.oval](const BodySurface::Slice&,
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
    const Lobes lobes = lobesAt(z_mm, oval, seed ^ 0x10beU);
    return Section{box, [=, pieces = std::move(pieces)](const Site& s) {
                     const Vec3 p{patientX(side, s.p_mm.x), s.p_mm.y, s.p_mm.z * flatness};
                     double nearest = 1e9;
                     for (const Piece& piece : pieces) {
                       const double t01 = std::clamp(dot(p - piece.from, piece.along) * piece.inverseLength2, 0.0, 1.0);
                       const Vec3 off = p - piece.from - piece.along * t01;
                       const double r = norm(off), radius = piece.radius + piece.widening * t01;
                       const double wide = oval > 0 && r > 1e-9 ? 1 + lobes(off.x / r, off.y / r) : 1;
                       nearest = std::min(nearest, r - radius * wide);
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
