#include "OpenLumens.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace insonate {
namespace {

/// Radius of the circle in which the lumen is searched: center lines are not exactly in the middle, and lumens not
/// round.
constexpr double kAround_radii = 1.5;
/// Smallest open area that counts as the whole lumen: lumens are not round, and voxels coarse.
constexpr double kOpen = 0.45;
/// Longest filled part between two named vessels.
constexpr double kLongest_mm = 60;
/// Smallest cosine of the angle between a vessel and the way to the vessel that continues it.
constexpr double kOnward = 0.8;

class LumenMap {
 public:
  explicit LumenMap(const LabelMap& labels) : labels_(labels), indexFromPatient_(labels.geometry.indexFromPatient()) {}

  /// Returns the open area of a cross-section, relative to that by the radius, at most 1.
  double openAt(std::uint8_t label, Vec3 middle_mm, Vec3 along, double radius_mm) const {
    constexpr double kHalf = 8;
    const Vec3 away = std::abs(along.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 side = normalized(cross(along, away)), other = cross(along, side);
    const double step_mm = kAround_radii * radius_mm / kHalf;
    int open = 0;
    for (double i = 0.5 - kHalf; i < kHalf; ++i)
      for (double k = 0.5 - kHalf; k < kHalf; ++k) {
        if (i * i + k * k > kHalf * kHalf) continue;
        const Vec3 at_mm = middle_mm + side * (i * step_mm) + other * (k * step_mm);
        open += sampleNearest(labels_, indexFromPatient_ * at_mm) == label;
      }
    const double area = open * step_mm * step_mm / (std::numbers::pi * radius_mm * radius_mm);
    return area >= kOpen ? 1 : area;
  }

 private:
  const LabelMap& labels_;
  const Transform indexFromPatient_;
};

Vec3 directionAt(const NamedVessel& vessel, std::size_t point) {
  const std::size_t last = vessel.course.size() - 1;
  const Vec3 way =
      vessel.course[std::min(point + 1, last)].position_mm - vessel.course[point > 0 ? point - 1 : 0].position_mm;
  return norm(way) > 0 ? normalized(way) : Vec3{0, 0, 1};
}

/// Smallest open area along the center line, between the first and the last part that is open: its ends may lie beyond
/// the lumen.
double openAlong(const LumenMap& map, const NamedVessel& vessel) {
  std::vector<double> areas;
  for (std::size_t i = 0; i < vessel.course.size(); ++i)
    areas.push_back(
        map.openAt(vessel.label, vessel.course[i].position_mm, directionAt(vessel, i), vessel.course[i].radius_mm));
  const auto first = std::ranges::find(areas, 1.0);
  const auto last = std::find(areas.rbegin(), areas.rend(), 1.0).base();
  return first < last ? *std::min_element(first, last) : 1;
}

/// An end of a vessel, with the direction away from the vessel.
struct VesselEnd {
  Vec3 at_mm, outward;
  double radius_mm;
};

VesselEnd endOf(const NamedVessel& vessel, bool first) {
  const std::size_t at = first ? 0 : vessel.course.size() - 1;
  return {vessel.course[at].position_mm, directionAt(vessel, at) * (first ? -1.0 : 1.0), vessel.course[at].radius_mm};
}

/// The part between two named vessels of which one continues the other.
struct Gap {
  NamedVessel filled;  ///< the part of the way that is filled; without points if all of it is open
  double length_mm = 0;
  double open = 1;  ///< smallest open area
};

std::optional<Gap> gapBetween(const LumenMap& map, const NamedVessel& vessel, bool beginsAtHeart,
                              const NamedVessel& next, bool nextBeginsAtHeart) {
  constexpr double kStep_mm = 2;
  const VesselEnd from = endOf(vessel, beginsAtHeart), to = endOf(next, !nextBeginsAtHeart);
  const Vec3 way = to.at_mm - from.at_mm;
  const double length_mm = norm(way);
  if (length_mm < 2 * kStep_mm || length_mm > kLongest_mm) return std::nullopt;
  const Vec3 along = way / length_mm;
  if (dot(along, from.outward) < kOnward || dot(along, to.outward) > -kOnward) return std::nullopt;
  Gap gap{{vessel.name, vessel.label, {}}, length_mm};
  const int steps = static_cast<int>(length_mm / kStep_mm);
  for (int i = 0; i <= steps; ++i) {
    const double t = double(i) / steps;
    const NamedVessel::Point point{from.at_mm + way * t, from.radius_mm + t * (to.radius_mm - from.radius_mm)};
    const double open = map.openAt(vessel.label, point.position_mm, along, point.radius_mm);
    if (open < 1) gap.filled.course.push_back(point);
    gap.open = std::min(gap.open, open);
  }
  return gap;
}

/// The gap toward the nearest vessel that continues a vessel.
std::optional<Gap> gapToHeart(const LumenMap& map, std::span<const NamedVessel> vessels,
                              const std::vector<bool>& beginsAtHeart, std::size_t of) {
  std::optional<Gap> best;
  for (std::size_t next = 0; next < vessels.size(); ++next) {
    if (next == of || vessels[next].label != vessels[of].label) continue;
    auto gap = gapBetween(map, vessels[of], beginsAtHeart[of], vessels[next], beginsAtHeart[next]);
    if (gap && (!best || gap->length_mm < best->length_mm)) best = std::move(gap);
  }
  const Vec3 end_mm = endOf(vessels[of], beginsAtHeart[of]).at_mm;
  const bool joins = std::ranges::any_of(vessels, [&](const NamedVessel& other) {
    return &other != &vessels[of] && other.label == vessels[of].label && distanceToWall_mm(other, end_mm) < 0;
  });
  return joins ? std::nullopt : best;
}

}  // namespace

std::vector<double> openLumens(std::span<const NamedVessel> vessels, const std::vector<bool>& beginsAtHeart,
                               const LabelMap& labels) {
  const LumenMap map(labels);
  std::vector<double> open;
  std::vector<Gap> filled;
  for (std::size_t v = 0; v < vessels.size(); ++v) {
    open.push_back(openAlong(map, vessels[v]));
    const auto gap = gapToHeart(map, vessels, beginsAtHeart, v);
    if (!gap) continue;
    open[v] = std::min(open[v], gap->open);
    if (gap->open < 1) filled.push_back(*gap);
  }
  for (std::size_t v = 0; v < vessels.size(); ++v) {
    const VesselEnd end = endOf(vessels[v], beginsAtHeart[v]);
    for (const Gap& gap : filled)
      if (gap.filled.label == vessels[v].label && distanceToWall_mm(gap.filled, end.at_mm) < end.radius_mm)
        open[v] = std::min(open[v], gap.open);
  }
  return open;
}

}  // namespace insonate
