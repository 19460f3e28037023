#include "color/FlowSegments.h"

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

float coordinate(double value) {
  return static_cast<float>(value);
}

}  // namespace

void FlowSegments::update(const BloodFlow& flow, const Transform& patientFromProbe, double reach_mm) {
  flow_ = &flow;
  segments_.clear();
  const Transform probeFromPatient = inverted(patientFromProbe);
  for (std::size_t t = 0; t < flow.tubes.size(); ++t) {
    const std::vector<BloodTube::Point>& course = flow.tubes[t].course;
    for (std::size_t s = 0; s == 0 || s + 1 < course.size(); ++s) {
      const BloodTube::Point &first = course[s], &second = course[std::min(s + 1, course.size() - 1)];
      const Vec3 a = probeFromPatient * first.position_mm, way = probeFromPatient * second.position_mm - a;
      const double off_mm = a.y * (a.y + way.y) <= 0 ? 0 : std::min(std::abs(a.y), std::abs(a.y + way.y));
      if (off_mm > reach_mm + kReach_radii * std::max(first.radius_mm, second.radius_mm)) continue;
      const double length2 = dot(way, way);
      const Vec3 d = probeFromPatient.linear * first.direction, e = probeFromPatient.linear * second.direction;
      segments_.push_back({coordinate(a.x), coordinate(a.y), coordinate(a.z), coordinate(way.x), coordinate(way.y),
                           coordinate(way.z), coordinate(length2 > 0 ? 1 / length2 : 0), coordinate(first.radius_mm),
                           coordinate(second.radius_mm - first.radius_mm), coordinate(first.scale),
                           coordinate(second.scale - first.scale), d, e - d, flow.tubes[t].label, static_cast<int>(t),
                           static_cast<int>(s)});
    }
  }
}

void FlowSegments::select(std::uint8_t label, Vec3 low_mm, Vec3 high_mm, std::vector<int>& near) const {
  near.clear();
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const FlowSegment& s = segments_[i];
    if (s.label != label) continue;
    const double reach_mm = kReach_radii * std::max(s.radius_mm, s.radius_mm + s.radiusChange);
    const auto apart = [&](double a, double change, double low, double high) {
      return std::max(a, a + change) + reach_mm < low || std::min(a, a + change) - reach_mm > high;
    };
    if (apart(s.x, s.dx, low_mm.x, high_mm.x) || apart(s.y, s.dy, low_mm.y, high_mm.y) ||
        apart(s.z, s.dz, low_mm.z, high_mm.z))
      continue;
    near.push_back(static_cast<int>(i));
  }
}

FlowPlace FlowSegments::find(std::span<const int> near, float x, float y, float z) const {
  float least2 = kReach_radii * kReach_radii, off2 = 0;
  FlowPlace best;
  for (const int i : near) {
    const FlowSegment& s = segments_[i];
    const float px = x - s.x, py = y - s.y, pz = z - s.z;
    const float t = std::clamp((px * s.dx + py * s.dy + pz * s.dz) * s.perLength2, 0.0F, 1.0F);
    const float qx = px - t * s.dx, qy = py - t * s.dy, qz = pz - t * s.dz;
    const float square = qx * qx + qy * qy + qz * qz, radius = s.radius_mm + t * s.radiusChange;
    if (square >= least2 * radius * radius) continue;
    least2 = square / (radius * radius);
    best.segment = i, best.along = t, off2 = square;
  }
  best.off_mm = std::sqrt(off2);
  return best;
}

float FlowSegments::along(std::span<const int> near, float x, float y, float z, float depth_mm, Vec3 beam) const {
  const FlowPlace place = find(near, x, y, z);
  if (place.segment < 0) return 0;
  const FlowSegment& s = segments_[place.segment];
  const double speed = flow_->tubes[s.tube].profileAt_mmps(place.off_mm / (place.off_mm + depth_mm));
  const double cosine = dot(s.direction, beam) + place.along * dot(s.directionChange, beam);
  return static_cast<float>((s.scale + place.along * s.scaleChange) * speed * cosine);
}

}  // namespace insonate
