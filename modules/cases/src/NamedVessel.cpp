#include <insonate/cases/PatientCase.h>

#include <algorithm>
#include <limits>

namespace insonate {
namespace {

/// Minimum of `measure(distance to a piece of the course, radius there)`.
template <class Measure>
double minAlong(const NamedVessel& vessel, Vec3 p_mm, const Measure& measure) noexcept {
  double least = std::numeric_limits<double>::infinity();
  const auto& course = vessel.course;
  for (std::size_t i = 0; i < course.size(); ++i) {
    const NamedVessel::Point &from = course[i], &to = course[std::min(i + 1, course.size() - 1)];
    const Vec3 along = to.position_mm - from.position_mm;
    const double length2 = dot(along, along);
    const double t = length2 > 0 ? std::clamp(dot(p_mm - from.position_mm, along) / length2, 0.0, 1.0) : 0;
    const double distance_mm = norm(p_mm - from.position_mm - along * t);
    least = std::min(least, measure(distance_mm, from.radius_mm + (to.radius_mm - from.radius_mm) * t));
  }
  return least;
}

}  // namespace

double distanceToWall_mm(const NamedVessel& vessel, Vec3 patient_mm) noexcept {
  return minAlong(vessel, patient_mm, [](double distance_mm, double radius_mm) { return distance_mm - radius_mm; });
}

double distanceToCenterLine_mm(const NamedVessel& vessel, Vec3 patient_mm) noexcept {
  return minAlong(vessel, patient_mm, [](double distance_mm, double) { return distance_mm; });
}

}  // namespace insonate
