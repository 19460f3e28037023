#include "CrossSections.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate::wire {
namespace {

constexpr int kRays = 24;
constexpr double kRay_mm = 0.1;     // step of a ray
constexpr double kFarthest = 2.5;   // end of a ray, in radii: beyond, it runs along another vessel
constexpr int kSmoothed = 2;        // points before and behind a point whose rays are averaged, since voxels are coarse
constexpr double kFlattest = 0.15;  // smallest axis of an ellipse by the largest

struct Rays {
  bool isMeasured = false;
  std::array<double, kRays> length_mm{};
};

struct CrossFrame {
  Vec3 along, u, v;
};

Vec3 rayDirection(const CrossFrame& frame, int ray) {
  const double angle = 2 * std::numbers::pi * ray / kRays;
  return frame.u * std::cos(angle) + frame.v * std::sin(angle);
}

/// Frames that turn as little as possible along the course.
std::vector<CrossFrame> framesAlong(const std::vector<NamedVessel::Point>& course) {
  std::vector<CrossFrame> frames;
  Vec3 u = std::abs(course.back().position_mm.x - course.front().position_mm.x) >
                   std::abs(course.back().position_mm.z - course.front().position_mm.z)
               ? Vec3{0, 0, 1}
               : Vec3{1, 0, 0};
  for (std::size_t i = 0; i < course.size(); ++i) {
    const Vec3 along =
        normalized(course[std::min(i + 1, course.size() - 1)].position_mm - course[i > 0 ? i - 1 : 0].position_mm);
    const Vec3 across = u - along * dot(u, along);
    u = norm(across) > 1e-3 ? normalized(across) : u;
    frames.push_back({along, u, cross(along, u)});
  }
  return frames;
}

Rays castRays(const NamedVessel::Point& point, const CrossFrame& frame, std::uint8_t label, const LabelMap& labels,
              const Transform& indexFromPatient) {
  Rays rays;
  const auto isLumen = [&](Vec3 p_mm) { return sampleNearest(labels, indexFromPatient * p_mm) == label; };
  if (!isLumen(point.position_mm)) return rays;
  rays.isMeasured = true;
  for (int ray = 0; ray < kRays; ++ray) {
    const Vec3 direction = rayDirection(frame, ray);
    double s_mm = 0;
    const double end_mm = kFarthest * point.radius_mm;
    while (s_mm < end_mm && isLumen(point.position_mm + direction * (s_mm + kRay_mm))) s_mm += kRay_mm;
    rays.length_mm[ray] = s_mm < end_mm ? s_mm + kRay_mm / 2 : point.radius_mm;
  }
  return rays;
}

/// Center and tensor of the ellipse with the area's moments of the outline that the rays end on.
Section ellipseOf(const Rays& rays, const CrossFrame& frame, NamedVessel::Point& point) {
  // Moments of a star: each ray stands for a sector.
  double area = 0, sx = 0, sy = 0, xx = 0, yy = 0, xy = 0;
  for (int ray = 0; ray < kRays; ++ray) {
    const double angle = 2 * std::numbers::pi * ray / kRays, c = std::cos(angle), s = std::sin(angle);
    const double r = rays.length_mm[ray], sector = 2 * std::numbers::pi / kRays;
    area += sector * r * r / 2;
    sx += sector * r * r * r / 3 * c, sy += sector * r * r * r / 3 * s;
    const double fourth = sector * r * r * r * r / 4;
    xx += fourth * c * c, yy += fourth * s * s, xy += fourth * c * s;
  }
  sx /= area, sy /= area;
  xx = xx / area - sx * sx, yy = yy / area - sy * sy, xy = xy / area - sx * sy;
  const double middle = (xx + yy) / 2, spread = std::hypot((xx - yy) / 2, xy);
  const double large = middle + spread, small = std::max(middle - spread, kFlattest * kFlattest * large);
  const double turn = 0.5 * std::atan2(2 * xy, xx - yy);
  const double a_mm = 2 * std::sqrt(large), b_mm = 2 * std::sqrt(small);  // an ellipse has variances a^2/4, b^2/4
  const Vec3 major = frame.u * std::cos(turn) + frame.v * std::sin(turn), minor = cross(frame.along, major);
  point.position_mm = point.position_mm + frame.u * sx + frame.v * sy;
  point.radius_mm = std::sqrt(a_mm * b_mm);
  const double p = 1 / (a_mm * a_mm), q = 1 / (b_mm * b_mm), r = 1 / (a_mm * b_mm);
  const auto entry = [&](int i, int j) {
    return p * major[i] * major[j] + q * minor[i] * minor[j] + r * frame.along[i] * frame.along[j];
  };
  return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)};
}

}  // namespace

Section roundSection(double radius_mm) {
  const double m = 1 / (radius_mm * radius_mm);
  return {m, m, m, 0, 0, 0};
}

std::vector<Section> measuredSections(NamedVessel& vessel, const LabelMap& labels) {
  const auto& course = vessel.course;
  const std::vector<CrossFrame> frames = framesAlong(course);
  const Transform indexFromPatient = labels.geometry.indexFromPatient();
  std::vector<Rays> rays;
  for (std::size_t i = 0; i < course.size(); ++i)
    rays.push_back(castRays(course[i], frames[i], vessel.label, labels, indexFromPatient));
  std::vector<Section> sections;
  const auto count = std::ssize(course);
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    NamedVessel::Point& point = vessel.course[i];
    Rays mean;
    int summed = 0;
    for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(i - kSmoothed, 0); k <= std::min(i + kSmoothed, count - 1); ++k) {
      if (!rays[k].isMeasured) continue;
      ++summed;
      for (int ray = 0; ray < kRays; ++ray) mean.length_mm[ray] += rays[k].length_mm[ray];
    }
    if (!rays[i].isMeasured || summed == 0) {
      sections.push_back(roundSection(point.radius_mm));
      continue;
    }
    for (double& length_mm : mean.length_mm) length_mm /= summed;
    sections.push_back(ellipseOf(mean, frames[i], point));
  }
  return sections;
}

}  // namespace insonate::wire
