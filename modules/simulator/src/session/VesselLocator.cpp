#include <insonate/cases/VesselName.h>
#include <insonate/procedure/AttemptEvent.h>
#include <insonate/simulator/VesselLocator.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <tuple>

namespace insonate {
namespace {

/// Index of the nearest line; the number of lines if there is none.
std::size_t nearestLine(std::span<const CenterLine> lines, Vec3 point_mm) noexcept {
  std::size_t nearest = lines.size();
  std::optional<double> min_mm;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto distance_mm = insonate::distanceToCenterLine_mm(lines.subspan(i, 1), point_mm);
    if (distance_mm && (!min_mm || *distance_mm < *min_mm)) min_mm = distance_mm, nearest = i;
  }
  return nearest;
}

/// A point within this distance of a wall of a named vessel is in that vessel.
constexpr double kAtWall_mm = 1;
/// Extent of a lumen that is not round beyond the wall of the round one.
constexpr double kFlat_mm = 4;
/// Maximum distance between the center line of a named vessel and its course.
constexpr double kOnCourse_mm = 3;

/// The point of the lines nearest to a place.
std::optional<Vec3> nearestOn(std::span<const CenterLine> lines, Vec3 point_mm) noexcept {
  std::optional<Vec3> nearest;
  for (const CenterLine& line : lines)
    for (const Vec3& on_mm : line)
      if (!nearest || norm(on_mm - point_mm) < norm(*nearest - point_mm)) nearest = on_mm;
  return nearest;
}

/// Tells whether a point outside the round wall of the nearest named vessel is in that vessel, and not in an unnamed
/// one beside it: a vein is identified by its center line.
bool isIn(const NamedVessel& vessel, Vec3 point_mm, std::span<const CenterLine> veins) noexcept {
  const double outside_mm = distanceToWall_mm(vessel, point_mm);
  if (outside_mm <= kAtWall_mm) return true;
  const auto on_mm = vessel.label == kVein ? nearestOn(veins, point_mm) : std::nullopt;
  return on_mm ? distanceToCenterLine_mm(vessel, *on_mm) <= kOnCourse_mm : outside_mm <= kFlat_mm;
}

constexpr std::size_t kMaxNames = kUnnamedVessel - 1;

/// Index of the vessel of this label whose wall is nearest; the number of vessels if there is none.
std::size_t nearestVessel(std::span<const NamedVessel> vessels, std::uint8_t label, Vec3 point_mm) noexcept {
  std::size_t nearest = vessels.size();
  double min_mm = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < vessels.size(); ++i) {
    if (vessels[i].label != label) continue;
    const double distance_mm = distanceToWall_mm(vessels[i], point_mm);
    if (distance_mm < min_mm) min_mm = distance_mm, nearest = i;
  }
  return nearest;
}

}  // namespace

VesselLocator::VesselLocator(const CaseManifest& manifest, const Procedure& procedure, Vec3 near_mm) {
  std::ranges::copy_if(manifest.targets, std::back_inserter(targets_),
                       [](const Target& target) { return target.label == kVein; });
  const auto rank = [&](const Target& target) {
    const bool fits = !procedure.target.empty() && namesVessel(target.name, procedure.target);
    return std::tuple(!fits, norm(target.position_mm - near_mm));
  };
  std::ranges::stable_sort(targets_, {}, rank);
  if (targets_.size() > kMaxNames) targets_.resize(kMaxNames);
  if (targets_.empty()) return;
  const std::size_t target = nearestVessel(manifest.vessels, kVein, targets_.front().position_mm);
  if (target == manifest.vessels.size() ||
      distanceToWall_mm(manifest.vessels[target], targets_.front().position_mm) > kFlat_mm)
    return;  // The target's vein has no name, only another one has.
  vessels_ = manifest.vessels;
  std::rotate(vessels_.begin(), vessels_.begin() + static_cast<std::ptrdiff_t>(target),
              vessels_.begin() + static_cast<std::ptrdiff_t>(target) + 1);
  if (vessels_.size() > kMaxNames) vessels_.resize(kMaxNames);
}

std::vector<std::string> VesselLocator::names() const {
  std::vector<std::string> names;
  for (const NamedVessel& vessel : vessels_) names.push_back(vessel.name);
  if (!vessels_.empty()) return names;
  for (const Target& target : targets_) names.push_back(target.name.empty() ? "target vein" : target.name);
  return names;
}

std::uint8_t VesselLocator::vesselAt(Label label, Vec3 rest_mm, std::span<const CenterLine> veins) const noexcept {
  if (targets_.empty()) return 0;
  if (!vessels_.empty()) {
    const std::size_t nearest = nearestVessel(vessels_, label, rest_mm);
    if (nearest == vessels_.size() || !isIn(vessels_[nearest], rest_mm, veins)) return kUnnamedVessel;
    return static_cast<std::uint8_t>(nearest + 1);
  }
  if (label != kVein) return 0;
  const std::size_t line = nearestLine(veins, rest_mm);
  if (line < veins.size())
    for (std::size_t i = 0; i < targets_.size(); ++i)
      if (nearestLine(veins, targets_[i].position_mm) == line) return static_cast<std::uint8_t>(i + 1);
  return kUnnamedVessel;
}

std::optional<double> VesselLocator::distanceToCenterLine_mm(Vec3 rest_mm, std::span<const CenterLine> veins,
                                                             std::uint8_t vessel) const noexcept {
  if (targets_.empty()) return insonate::distanceToCenterLine_mm(veins, rest_mm);
  const std::size_t index = vessel - 1U;
  if (!vessels_.empty())
    return index < vessels_.size() ? std::optional(insonate::distanceToCenterLine_mm(vessels_[index], rest_mm))
                                   : std::nullopt;
  const std::size_t line = index < targets_.size() ? nearestLine(veins, targets_[index].position_mm) : veins.size();
  if (line == veins.size()) return std::nullopt;
  return insonate::distanceToCenterLine_mm(veins.subspan(line, 1), rest_mm);
}

}  // namespace insonate
