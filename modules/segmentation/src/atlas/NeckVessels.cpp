#include "NeckVessels.h"

#include "vessel/LumenFill.h"
#include "vessel/SectionLine.h"

#include <insonate/segmentation/TubeTracking.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace insonate::segmentation {
namespace {

constexpr double kShortestVessel_mm = 15, kBetweenClicks_mm = 12;
/// Greatest distance of the wall from the center, in expected radii: arteries are round, veins may be flat.
constexpr double kWidestArtery = 1.4, kWidestVein = 2.2;

struct Search {
  std::vector<FoundStation> stations;
  double evidence = 0;
  bool isFilled = false;
};

Search searched(const CtVolume& ct, const std::vector<VesselStation>& expected, bool isFilled,
                const std::vector<TakenStation>& taken, Work& work) {
  Search search{searchedVessel(ct, expected, isFilled, taken, work), 0, isFilled};
  for (const FoundStation& station : search.stations)
    search.evidence += station.evidence / double(search.stations.size());
  return search;
}

std::vector<Vec3> clicksOn(const std::vector<Vec3>& path) {
  const double length_mm = norm(path.back() - path.front());
  const int parts = std::max(1, static_cast<int>(std::lround(length_mm / kBetweenClicks_mm)));
  std::vector<Vec3> clicks_mm;
  for (int n = 0; n <= parts; ++n) clicks_mm.push_back(path[(path.size() - 1) * std::size_t(n) / std::size_t(parts)]);
  return clicks_mm;
}

double distanceTo(const std::vector<Vec3>& line, Vec3 at_mm) {
  return *distanceToCenterLine_mm(std::array{line}, at_mm);
}

double radiusOf(const VesselOutline& outline) {
  return std::sqrt(outline.area_mm2() / std::numbers::pi);
}

void measure(NeckVessel& vessel, const Search& search, const std::vector<VesselStation>& expected,
             const std::vector<Vec3>& path) {
  constexpr int kWindow = 3;  // stations on both sides
  const int count = static_cast<int>(expected.size());
  VesselSigns& signs = vessel.signs;
  signs.evidence = search.evidence, signs.weakest = 1;
  double radius = 0;
  for (int n = 0; n < count; ++n) {
    double here = 0;
    const int first = std::max(0, n - kWindow), last = std::min(count - 1, n + kWindow);
    for (int m = first; m <= last; ++m) here += search.stations[m].evidence / (last - first + 1);
    if (here < signs.weakest) signs.weakest = here, vessel.weakest_mm = path[n];
    signs.offCourse += norm(path[n] - expected[n].center_mm) / expected[n].spread_mm / count;
    signs.offPath += distanceTo(vessel.tracked.line, path[n]) / expected[n].radius_mm / count;
    radius += expected[n].radius_mm / count;
  }
  double found = 0;
  for (const VesselOutline& outline : vessel.tracked.outlines)
    found += radiusOf(outline) / double(vessel.tracked.outlines.size());
  signs.widening = found / radius;
}

/// Limits the outlines to sizes that are possible for the vessel, so that it does not extend into a vessel that it
/// joins.
void limitOutlines(TrackedVessel& vessel, const std::vector<VesselStation>& expected, double widest,
                   const VolumeGeometry& geometry) {
  for (VesselOutline& outline : vessel.outlines) {
    const auto station = std::ranges::min_element(
        expected, {}, [&](const VesselStation& one) { return std::abs(one.center_mm.z - outline.center_mm.z); });
    for (double& radius_mm : outline.radius_mm) radius_mm = std::min(radius_mm, widest * station->radius_mm);
  }
  vessel.lumen = fillLumen(geometry, vessel.outlines);
}

}  // namespace

std::optional<NeckVessel> foundVessel(const CtVolume& ct, const std::vector<VesselStation>& expected, bool isArtery,
                                      const std::vector<TakenStation>& taken, Work& work) {
  if (expected.size() < 4 || norm(expected.back().center_mm - expected.front().center_mm) < kShortestVessel_mm)
    return std::nullopt;
  Search search = searched(ct, expected, false, taken, work);
  if (Search filled = searched(ct, expected, true, taken, work); filled.evidence > search.evidence)
    search = std::move(filled);
  std::vector<Vec3> path;
  for (const FoundStation& station : search.stations) path.push_back(station.center_mm);
  path = smoothed(path, 3);

  double radius_mm = 0;
  for (const VesselStation& station : expected) radius_mm += station.radius_mm / double(expected.size());
  const double largest_mm = std::clamp(2.4 * radius_mm, 5.0, 14.0);
  const Progress checked = [&work](std::string_view, double) {
    work.checkpoint();
    return true;
  };
  const auto clicks_mm = clicksOn(path);
  Result<TrackedVessel> tracked = fail("");
  if (search.isFilled) tracked = trackVessel(ct, clicks_mm, {.largest_mm = largest_mm}, checked);
  if (!tracked) tracked = trackTube(ct, clicks_mm, {.largest_mm = largest_mm}, checked);
  if (!tracked) return std::nullopt;
  NeckVessel vessel;
  vessel.tracked = std::move(*tracked);
  limitOutlines(vessel.tracked, expected, isArtery ? kWidestArtery : kWidestVein, ct.geometry);
  measure(vessel, search, expected, path);
  for (const VesselOutline& outline : vessel.tracked.outlines)
    vessel.taken.push_back({outline.center_mm, radiusOf(outline)});
  return vessel;
}

double confidenceOf(const VesselSigns& signs) {
  const double sum = -3 + 8 * signs.evidence + 3 * signs.weakest - 0.6 * signs.offCourse - 2 * signs.offPath -
                     3 * std::abs(std::log(std::max(signs.widening, 0.1)));
  return 1 / (1 + std::exp(-sum));
}

}  // namespace insonate::segmentation
