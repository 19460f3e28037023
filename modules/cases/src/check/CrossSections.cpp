#include "CrossSections.h"

#include "Checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace insonate::check {
namespace {

constexpr double kGrain_mm = 0.5, kHalfCut_mm = 25, kBetween_mm = 2;
constexpr int kSide = 2 * int(kHalfCut_mm / kGrain_mm) + 1;

/// Label map and vessel that all cuts through a vessel share.
struct VesselCutter {
  const LabelMap& labels;
  Transform indexFromPatient;
  const NamedVessel& vessel;
  std::vector<const NamedVessel*> rivals;  ///< other vessels with the same label

  std::uint8_t labelAt(Vec3 place_mm) const { return sampleNearest(labels, indexFromPatient * place_mm); }
  bool isOwn(Vec3 place_mm) const {
    const double distance_mm = distanceToWall_mm(vessel, place_mm);
    return std::ranges::none_of(
        rivals, [&](const NamedVessel* rival) { return distanceToWall_mm(*rival, place_mm) < distance_mm; });
  }
};

struct CutPlane {
  Vec3 center_mm, first, second;

  CutPlane(Vec3 center, Vec3 normal)
      : center_mm(center),
        first(normalized(cross(normal, std::abs(normal.x) < 0.8 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}))),
        second(normalized(cross(normal, first))) {}
  Vec3 placeOf(std::array<int, 2> at) const {
    return center_mm + (kGrain_mm * (at[0] - kSide / 2)) * first + (kGrain_mm * (at[1] - kSide / 2)) * second;
  }
};

/// Center lines may leave a flat lumen: the labeled pixel nearest to the center, no farther than the wall.
std::optional<std::array<int, 2>> startOf(const VesselCutter& cutter, const CutPlane& plane, double radius_mm) {
  const int reach = std::min(kSide / 2, int(std::max(2.0, radius_mm) / kGrain_mm));
  std::optional<std::array<int, 2>> start;
  int nearest = std::numeric_limits<int>::max();
  for (int j = -reach; j <= reach; ++j)
    for (int i = -reach; i <= reach; ++i) {
      const std::array<int, 2> at{kSide / 2 + i, kSide / 2 + j};
      if (i * i + j * j >= nearest || cutter.labelAt(plane.placeOf(at)) != cutter.vessel.label) continue;
      if (!cutter.isOwn(plane.placeOf(at))) continue;
      nearest = i * i + j * j;
      start = at;
    }
  return start;
}

void measureMoments(const std::vector<std::array<int, 2>>& pixels, CrossSection& section) {
  const double n = double(pixels.size());
  double x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  for (const auto& at : pixels) {
    x += at[0], y += at[1];
    xx += double(at[0]) * at[0], yy += double(at[1]) * at[1], xy += double(at[0]) * at[1];
  }
  xx = xx / n - x * x / n / n, yy = yy / n - y * y / n / n, xy = xy / n - x * y / n / n;
  const double spread = std::hypot((xx - yy) / 2, xy), mid = (xx + yy) / 2;
  section.area_mm2 = n * kGrain_mm * kGrain_mm;
  section.width_mm = 4 * std::sqrt(mid + spread) * kGrain_mm;
  section.height_mm = 4 * std::sqrt(std::max(0.0, mid - spread)) * kGrain_mm;
}

CrossSection cut(const VesselCutter& cutter, const CutPlane& plane, double radius_mm) {
  CrossSection section{plane.center_mm};
  const auto start = startOf(cutter, plane, radius_mm);
  if (!start) return section;
  std::vector<char> seen(std::size_t(kSide) * kSide);
  std::vector<std::array<int, 2>> pixels;
  const auto add = [&](int i, int j) {
    if (i < 0 || j < 0 || i >= kSide || j >= kSide || std::exchange(seen[std::size_t(j) * kSide + std::size_t(i)], 1))
      return;
    const Vec3 place_mm = plane.placeOf({i, j});
    if (!inVolume(cutter.labels.geometry, place_mm)) {
      section.isWhole = false;
    } else if (cutter.labelAt(place_mm) == cutter.vessel.label) {
      if (cutter.isOwn(place_mm))
        pixels.push_back({i, j});
      else
        section.isWhole = false;
    }
  };
  add((*start)[0], (*start)[1]);
  for (std::size_t n = 0; n < pixels.size(); ++n) {
    const auto [i, j] = pixels[n];
    add(i + 1, j), add(i - 1, j), add(i, j + 1), add(i, j - 1);
  }
  measureMoments(pixels, section);
  return section;
}

/// The course in equal steps.
std::vector<NamedVessel::Point> evenCourse(const NamedVessel& vessel) {
  std::vector<NamedVessel::Point> points;
  double next_mm = 0, length_mm = 0;
  for (std::size_t n = 0; n + 1 < vessel.course.size(); ++n) {
    const NamedVessel::Point &from = vessel.course[n], &to = vessel.course[n + 1];
    const double piece_mm = norm(to.position_mm - from.position_mm);
    for (; next_mm < length_mm + piece_mm; next_mm += kBetween_mm) {
      const double t = (next_mm - length_mm) / piece_mm;
      points.push_back({from.position_mm + t * (to.position_mm - from.position_mm),
                        from.radius_mm + t * (to.radius_mm - from.radius_mm)});
    }
    length_mm += piece_mm;
  }
  return points;
}

}  // namespace

double CrossSection::diameter_mm() const {
  return 2 * std::sqrt(area_mm2 / std::numbers::pi);
}

std::vector<CrossSection> crossSectionsOf(const CaseView& patient, const NamedVessel& vessel, double suspect_mm) {
  constexpr std::size_t kSmooth = 3;  // steps, to either side, over which the direction is taken
  const std::vector<NamedVessel::Point> points = evenCourse(vessel);
  std::vector<CrossSection> sections;
  for (std::size_t n = 0; n < points.size(); ++n) {
    const Vec3 center_mm = points[n].position_mm;
    const Vec3 along = points[std::min(n + kSmooth, points.size() - 1)].position_mm -
                       points[n < kSmooth ? 0 : n - kSmooth].position_mm;
    if (norm(along) <= 0 || !inVolume(patient.labels.geometry, center_mm)) continue;
    VesselCutter cutter{patient.labels, patient.labels.geometry.indexFromPatient(), vessel, {}};
    for (const NamedVessel& other : patient.manifest.vessels)
      if (&other != &vessel && other.label == vessel.label && distanceToWall_mm(other, center_mm) < kHalfCut_mm)
        cutter.rivals.push_back(&other);
    sections.push_back(cut(cutter, {center_mm, normalized(along)}, points[n].radius_mm));
    if (sections.back().diameter_mm() <= suspect_mm) continue;
    for (const Vec3& normal : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
      const CrossSection other = cut(cutter, {center_mm, normal}, points[n].radius_mm);
      if (other.area_mm2 > 0 && other.area_mm2 < sections.back().area_mm2) sections.back() = other;
    }
  }
  return sections;
}

}  // namespace insonate::check
