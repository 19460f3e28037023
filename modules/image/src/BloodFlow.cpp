#include <insonate/image/BloodFlow.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

/// A lumen in a CT is not exactly as wide as the stated radius, and vessels become wider where they join.
constexpr double kReach_radii = 1.7;

}  // namespace

double BloodTube::profileAt_mmps(double fromCenter) const {
  if (fromCenter >= 1) return 0;
  const double at = std::max(fromCenter, 0.0) * (kProfile - 1);
  const int low = std::min(static_cast<int>(at), kProfile - 2);
  return profile_mmps[low] + (at - low) * (profile_mmps[low + 1] - profile_mmps[low]);
}

std::optional<PlaceInTube> placeInTubes(const BloodFlow& flow, std::uint8_t label, Vec3 patient_mm) {
  std::optional<PlaceInTube> best;
  double least_radii = kReach_radii;
  for (const BloodTube& tube : flow.tubes) {
    if (tube.label != label) continue;
    const int segments = std::max(1, static_cast<int>(tube.course.size()) - 1);
    for (int s = 0; s < segments; ++s) {
      const BloodTube::Point &a = tube.course[s],
                             &b = tube.course[std::min<std::size_t>(s + 1, tube.course.size() - 1)];
      const Vec3 way = b.position_mm - a.position_mm;
      const double length2 = dot(way, way);
      const double along = length2 > 0 ? std::clamp(dot(patient_mm - a.position_mm, way) / length2, 0.0, 1.0) : 0;
      const double off_mm = norm(patient_mm - a.position_mm - way * along);
      const double radii = off_mm / (a.radius_mm + along * (b.radius_mm - a.radius_mm));
      if (radii >= least_radii) continue;
      least_radii = radii;
      best = {&tube, s, along, off_mm};
    }
  }
  return best;
}

Vec3 bloodVelocity_mmps(const BloodFlow& flow, std::uint8_t label, Vec3 patient_mm, double depth_mm) {
  if (depth_mm <= 0) return {};
  const auto place = placeInTubes(flow, label, patient_mm);
  if (!place) return {};
  const std::vector<BloodTube::Point>& course = place->tube->course;
  const BloodTube::Point &a = course[place->segment],
                         &b = course[std::min<std::size_t>(place->segment + 1, course.size() - 1)];
  const double scale = a.scale + place->along * (b.scale - a.scale);
  const double speed_mmps =
      scale * place->tube->profileAt_mmps(place->fromCenter_mm / (place->fromCenter_mm + depth_mm));
  return (a.direction + place->along * (b.direction - a.direction)) * speed_mmps;
}

}  // namespace insonate
