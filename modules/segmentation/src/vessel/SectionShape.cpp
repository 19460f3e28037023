#include "SectionShape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate::segmentation {
namespace {

constexpr double kFlattest = 4;

std::pair<double, double> direction(int ray) {
  const double angle = 2 * std::numbers::pi * ray / VesselOutline::kRays;
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

SectionMoments meanMoments(const std::vector<SectionMoments>& sections, int n, int reach) {
  const int first = std::max(0, n - reach), last = std::min(int(sections.size()) - 1, n + reach);
  SectionMoments mean;
  for (int m = first; m <= last; ++m) {
    const auto& [x, y, xx, xy, yy] = sections[m];
    const double share = 1.0 / (last - first + 1);
    mean.x += x * share, mean.y += y * share;
    mean.xx += xx * share, mean.xy += xy * share, mean.yy += yy * share;
  }
  return mean;
}

SectionShape::SectionShape(const SectionMoments& m) {
  const double angle = 0.5 * std::atan2(2 * m.xy, m.xx - m.yy);
  const double mean = (m.xx + m.yy) / 2, half = std::hypot((m.xx - m.yy) / 2, m.xy);
  if (!(mean > half)) return;
  const double ratio = std::min(std::sqrt((mean + half) / (mean - half)), kFlattest);
  const double longer = std::sqrt(ratio), shorter = 1 / longer, c = std::cos(angle), s = std::sin(angle);
  xx_ = c * c * longer + s * s * shorter;
  xy_ = c * s * (longer - shorter);
  yy_ = s * s * longer + c * c * shorter;
}

std::pair<double, double> SectionShape::along(int ray) const {
  const auto [u, v] = direction(ray);
  return {xx_ * u + xy_ * v, xy_ * u + yy_ * v};
}

std::array<std::pair<double, double>, VesselOutline::kRays> SectionShape::corners(const Radii& radii) const {
  std::array<std::pair<double, double>, VesselOutline::kRays> all;
  for (int n = 0; n < VesselOutline::kRays; ++n) {
    const auto [x, y] = along(n);
    all[n] = {x * radii[n], y * radii[n]};
  }
  return all;
}

SectionMoments SectionShape::momentsOf(const Radii& radii) const {
  // Sums over the triangles between the center and two corners.
  const auto at = corners(radii);
  SectionMoments m;
  double twiceArea = 0;
  for (int n = 0; n < VesselOutline::kRays; ++n) {
    const auto [ax, ay] = at[n];
    const auto [bx, by] = at[(n + 1) % VesselOutline::kRays];
    const double w = ax * by - ay * bx;
    twiceArea += w;
    m.x += w * (ax + bx) / 3, m.y += w * (ay + by) / 3;
    m.xx += w * (ax * ax + ax * bx + bx * bx) / 6, m.yy += w * (ay * ay + ay * by + by * by) / 6;
    m.xy += w * (2 * ax * ay + 2 * bx * by + ax * by + ay * bx) / 12;
  }
  m.x /= twiceArea, m.y /= twiceArea;
  m.xx = m.xx / twiceArea - m.x * m.x, m.yy = m.yy / twiceArea - m.y * m.y, m.xy = m.xy / twiceArea - m.x * m.y;
  return m;
}

Radii SectionShape::unstretched(const Radii& radii) const {
  const auto at = corners(radii);
  Radii round{};
  for (int ray = 0; ray < VesselOutline::kRays; ++ray) {
    const auto [u, v] = direction(ray);
    for (int n = 0; n < VesselOutline::kRays; ++n) {
      // Intersection of the ray with the side from a to b: share of the side, and distance.
      const auto [ax, ay] = at[n];
      const auto [bx, by] = at[(n + 1) % VesselOutline::kRays];
      const double across = u * (by - ay) - v * (bx - ax);
      if (std::abs(across) < 1e-12) continue;
      const double away = (ax * by - ay * bx) / across, share = (ax * v - ay * u) / across;
      if (away > 0 && share >= -1e-9 && share <= 1 + 1e-9) round[ray] = std::max(round[ray], away);
    }
  }
  return round;
}

}  // namespace insonate::segmentation
