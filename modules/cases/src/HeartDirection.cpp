#include <insonate/cases/HeartDirection.h>
#include <insonate/cases/VesselName.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace insonate {
namespace {

double averageRadius_mm(const NamedVessel& vessel) {
  double sum = 0;
  for (const NamedVessel::Point& point : vessel.course) sum += point.radius_mm;
  return sum / static_cast<double>(vessel.course.size());
}

/// End of a vessel that is nearer to the heart, along the vessels.
enum class HeartEnd { Caudal, Cranial, Medial };

/// Anatomy by name; a vessel may be wider than the one that it joins, e.g. above a valve.
struct KnownCourse {
  std::string_view name;
  HeartEnd end;
};
constexpr std::array kKnownCourses{
    KnownCourse{"internal jugular", HeartEnd::Caudal},   KnownCourse{"external jugular", HeartEnd::Caudal},
    KnownCourse{"anterior jugular", HeartEnd::Caudal},   KnownCourse{"carotid", HeartEnd::Caudal},
    KnownCourse{"vertebral", HeartEnd::Caudal},          KnownCourse{"brachiocephalic", HeartEnd::Caudal},
    KnownCourse{"superior vena cava", HeartEnd::Caudal}, KnownCourse{"inferior vena cava", HeartEnd::Cranial},
    KnownCourse{"femoral", HeartEnd::Cranial},           KnownCourse{"iliac", HeartEnd::Cranial},
    KnownCourse{"saphenous", HeartEnd::Cranial},         KnownCourse{"brachial", HeartEnd::Cranial},
    KnownCourse{"basilic", HeartEnd::Cranial},           KnownCourse{"cephalic", HeartEnd::Cranial},
    KnownCourse{"subclavian", HeartEnd::Medial},         KnownCourse{"axillary", HeartEnd::Medial}};

/// Direction along an axis of the body in which a vessel leads to the heart, if its name says so. Patient LPS: +x is
/// toward the patient's left.
std::optional<Vec3> heartwardByName(std::string_view name) {
  const auto known =
      std::ranges::find_if(kKnownCourses, [&](const KnownCourse& course) { return namesVessel(name, course.name); });
  if (known == kKnownCourses.end()) return std::nullopt;
  if (known->end == HeartEnd::Caudal) return Vec3{0, 0, -1};
  if (known->end == HeartEnd::Cranial) return Vec3{0, 0, 1};
  const auto side = parsedVesselName(name).side;
  if (!side) return std::nullopt;
  return Vec3{*side == BodySide::Right ? 1.0 : -1.0, 0, 0};
}

bool joins(Vec3 end_mm, const NamedVessel& vessel, const NamedVessel& other) {
  return &vessel != &other && vessel.label == other.label && averageRadius_mm(other) > averageRadius_mm(vessel) &&
         distanceToWall_mm(other, end_mm) < 0;
}

/// Direction of a center line toward the heart at its point nearest to `near_mm`; zero if all its points are one.
Vec3 heartwardAt(const NamedVessel& vessel, std::span<const NamedVessel> all, Vec3 near_mm) {
  const auto& course = vessel.course;
  const auto distance_mm = [&](const NamedVessel::Point& point) { return norm(point.position_mm - near_mm); };
  const auto nearest = std::ranges::min_element(course, {}, distance_mm);
  const auto at = static_cast<std::size_t>(nearest - course.begin());
  const Vec3 way = course[std::min(at + 1, course.size() - 1)].position_mm - course[at > 0 ? at - 1 : 0].position_mm;
  if (norm(way) <= 0) return {};
  return normalized(beginsAtHeart(vessel, all) ? -way : way);
}

}  // namespace

bool beginsAtHeart(const NamedVessel& vessel, std::span<const NamedVessel> all) {
  const Vec3 first = vessel.course.front().position_mm, last = vessel.course.back().position_mm;
  if (const auto known = heartwardByName(vessel.name)) return dot(first - last, *known) > 0;
  const auto inLarger = [&](Vec3 end_mm) {
    return std::ranges::any_of(all, [&](const NamedVessel& other) { return joins(end_mm, vessel, other); });
  };
  const bool firstJoins = inLarger(first), lastJoins = inLarger(last);
  if (firstJoins != lastJoins) return firstJoins;
  // The heart lies caudal and near the middle. For level vessels, the end nearer to the middle is the nearer one.
  constexpr double kLevel = 0.3;
  const double height_mm = first.z - last.z;
  if (std::abs(height_mm) > kLevel * norm(first - last)) return height_mm < 0;
  double middle_mm = 0;
  for (const NamedVessel& other : all) middle_mm += other.course.front().position_mm.x / double(all.size());
  return std::abs(first.x - middle_mm) <= std::abs(last.x - middle_mm);
}

std::optional<Vec3> veinTowardHeart(const CaseManifest& manifest, Vec3 near_mm) {
  const NamedVessel* vein = nullptr;
  double nearest_mm = std::numeric_limits<double>::infinity();
  for (const NamedVessel& vessel : manifest.vessels) {
    if (vessel.label != kVein) continue;
    const double distance_mm = distanceToCenterLine_mm(vessel, near_mm);
    if (distance_mm < nearest_mm) vein = &vessel, nearest_mm = distance_mm;
  }
  if (vein) {
    const Vec3 way = heartwardAt(*vein, manifest.vessels, near_mm);
    return norm(way) > 0 ? std::optional(way) : heartwardByName(vein->name);
  }
  const Target* target = nullptr;
  for (const Target& each : manifest.targets)
    if (each.label == kVein && (!target || norm(each.position_mm - near_mm) < norm(target->position_mm - near_mm)))
      target = &each;
  return target ? heartwardByName(target->name) : std::nullopt;
}

}  // namespace insonate
