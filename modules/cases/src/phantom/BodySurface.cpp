#include "BodySurface.h"

#include "Noise.h"

#include <array>
#include <cmath>
#include <numbers>

namespace insonate::phantom {
namespace {

constexpr int kTableSize = 720;
constexpr double kStep_mm = 0.5;  ///< step for the slope between levels
constexpr double kUnevenFat_mm = 5;
constexpr double kFullTurn = 2 * std::numbers::pi;

double radiusAt(const std::array<double, 9>& radii, double angle) {
  const double a = std::abs(angle) / (std::numbers::pi / 8);
  const int k = std::min(static_cast<int>(a), 7);
  const double t = a - k;
  // The profile is symmetric about front and back, so that the neighbors beyond the ends are mirror images.
  const auto at = [&](int n) { return radii[n < 0 ? -n : n > 8 ? 16 - n : n]; };
  const double p0 = at(k - 1), p1 = at(k), p2 = at(k + 1), p3 = at(k + 2);
  return p1 + 0.5 * t * (p2 - p0 + t * (2 * p0 - 5 * p1 + 4 * p2 - p3 + t * (3 * (p1 - p2) + p3 - p0)));
}

}  // namespace

namespace {

/// A place on the outline for noise that is continuous all around.
Vec3 onOutline(double angle, double z_mm) {
  return {50 * std::sin(angle), 50 * std::cos(angle), z_mm};
}

/// Smooth noise over the outline; its structures are longer along the neck by half.
double overOutline(Vec3 at_mm, double cell_mm, std::uint32_t seed) {
  return smoothNoise({at_mm.x / cell_mm, at_mm.y / cell_mm, at_mm.z / (1.5 * cell_mm)}, seed);
}

}  // namespace

double BodySurface::fat_mm(double angle, double z_mm) const {
  const Vec3 at = onOutline(angle, z_mm);
  const double uneven = 0.3 * overOutline(at, 34, options_.seed ^ 0x51a7U) +
                        0.18 * overOutline(at, 15, options_.seed ^ 0x51a8U) +
                        0.08 * overOutline(at, 7, options_.seed ^ 0x51a9U);
  const double back = 0.5 * (1 - std::cos(angle));
  // The amplitude does not increase with the thickness of fat, and is small at the back, where fat is tense.
  const double rise_mm = std::min(options_.fat_mm, kUnevenFat_mm) * uneven * (1 - 0.7 * back * back);
  return (options_.fat_mm + rise_mm) * options_.outline->fatFactor(angle, z_mm);
}

double BodySurface::skin_mm(double angle, double z_mm) const {
  const Vec3 at = onOutline(angle, z_mm);
  return options_.skin_mm *
         (1 + 0.14 * overOutline(at, 26, options_.seed ^ 0x77U) + 0.1 * overOutline(at, 8, options_.seed ^ 0x78U));
}

BodySurface::Level BodySurface::level(double z_mm) const {
  return {z_mm, options_.outline->fascia_mm(z_mm), options_.outline->fascia_mm(z_mm + kStep_mm),
          options_.outline->fascia_mm(z_mm - kStep_mm)};
}

BodySurface::Ray BodySurface::ray(const Level& level, double angle) const {
  constexpr double kTurn = 0.01;
  const double r = radiusAt(level.here, angle) + options_.girth_mm;
  const double byAngle = (radiusAt(level.here, angle + kTurn) - radiusAt(level.here, angle - kTurn)) / (2 * kTurn * r);
  const double byLevel = (radiusAt(level.above, angle) - radiusAt(level.below, angle)) / (2 * kStep_mm);
  const double skin = skin_mm(angle, level.z_mm);
  return {r, 1 / std::sqrt(1 + byAngle * byAngle + byLevel * byLevel), fat_mm(angle, level.z_mm) + skin, skin};
}

double BodySurface::belowSkin_mm(Vec3 p_mm) const {
  const double front = kAxisY_mm - p_mm.y;
  const Ray r = ray(level(p_mm.z), std::atan2(-p_mm.x, front));
  return (r.radius_mm - std::hypot(p_mm.x, front)) * r.slant + r.layers_mm;
}

BodySurface::Slice BodySurface::slice(double z_mm) const {
  Slice s;
  const Level here = level(z_mm);
  for (int n = 0; n < kTableSize; ++n) s.rays_.push_back(ray(here, n * kFullTurn / kTableSize - std::numbers::pi));
  return s;
}

BodySurface::Ray BodySurface::Slice::at(double angle) const {
  const double a = (angle + std::numbers::pi) * (kTableSize / kFullTurn);
  const int n = static_cast<int>(std::floor(a));
  const double t = a - n;
  const Ray& low = rays_[((n % kTableSize) + kTableSize) % kTableSize];
  const Ray& high = rays_[(((n + 1) % kTableSize) + kTableSize) % kTableSize];
  return {low.radius_mm + (high.radius_mm - low.radius_mm) * t, low.slant + (high.slant - low.slant) * t,
          low.layers_mm + (high.layers_mm - low.layers_mm) * t, low.skin_mm + (high.skin_mm - low.skin_mm) * t};
}

Site BodySurface::Slice::site(Vec3 p_mm) const {
  Site s;
  s.p_mm = p_mm;
  const double front = kAxisY_mm - p_mm.y;
  s.angle = std::atan2(-p_mm.x, front);
  const Ray r = at(s.angle);
  // First-order distance to the implicit surface radius(angle, z) = r.
  s.belowFascia_mm = (r.radius_mm - std::sqrt(p_mm.x * p_mm.x + front * front)) * r.slant;
  s.belowSkin_mm = s.belowFascia_mm + r.layers_mm;
  s.skin_mm = r.skin_mm;
  return s;
}

}  // namespace insonate::phantom
