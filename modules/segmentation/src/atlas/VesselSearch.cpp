#include "VesselSearch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace insonate::segmentation {
namespace {

constexpr double kPlace_mm = 0.7;
constexpr int kReach = 13;  // of the search on both sides, in steps
constexpr int kRim = 18;    // of the averaged patch beyond the search, in steps
constexpr int kHalf = kReach + kRim, kWidth = 2 * kHalf + 1, kPlaces = 2 * kReach + 1;
constexpr int kRays = 16;
constexpr int kAveragedStations = 2;  // stations on both sides
constexpr double kRimDrop_HU = 30;    // a rim darker by this much is as good as any
constexpr double kFilledDrop_HU = 80;
constexpr double kUneven_HU = 20;                // standard deviation at which a section no longer looks like blood
constexpr double kEvidence = 6, kSmooth = 0.35;  // weights against (distance / spread)^2 / 2
constexpr int kMaxShift = 2;                     // steps from one station to the next

/// The CT in the plane of a station, averaged over the neighboring stations along the expected course.
using Patch = std::vector<float>;

float valueAt(const Patch& patch, double x, double y) {
  const double u = std::clamp(x / kPlace_mm + kHalf, 0.0, kWidth - 1.001);
  const double v = std::clamp(y / kPlace_mm + kHalf, 0.0, kWidth - 1.001);
  const int i = static_cast<int>(u), j = static_cast<int>(v);
  const auto a = static_cast<float>(u - i), b = static_cast<float>(v - j);
  const float* row = &patch[std::size_t(j) * kWidth + i];
  return (row[0] * (1 - a) + row[1] * a) * (1 - b) + (row[kWidth] * (1 - a) + row[kWidth + 1] * a) * b;
}

Patch patchAt(const CtVolume& ct, const Transform& indexFromPatient, const std::vector<VesselStation>& line, int n) {
  Patch patch(std::size_t(kWidth) * kWidth);
  const int first = std::max(0, n - kAveragedStations), last = std::min(int(line.size()) - 1, n + kAveragedStations);
  for (int m = first; m <= last; ++m)
    for (int v = 0; v < kWidth; ++v)
      for (int u = 0; u < kWidth; ++u) {
        const Vec3 at_mm = line[m].center_mm + Vec3{(u - kHalf) * kPlace_mm, (v - kHalf) * kPlace_mm, 0};
        patch[std::size_t(v) * kWidth + u] +=
            static_cast<float>(sampleLinear(ct, indexFromPatient * at_mm) / (last - first + 1));
      }
  return patch;
}

/// Evidence for a section with its center at (x, y), mm.
double evidenceAt(const Patch& patch, double x, double y, double radius_mm, bool isFilled) {
  constexpr double kLowest_HU = -20, kUsual_HU = 28, kHighest_HU = 75, kFilled_HU = 110;
  const double inner = 0.6 * radius_mm;
  double sum = 0, squares = 0, count = 0;
  for (double dy = -inner; dy <= inner; dy += kPlace_mm)
    for (double dx = -inner; dx <= inner; dx += kPlace_mm) {
      if (std::hypot(dx, dy) > inner) continue;
      const double hu = valueAt(patch, x + dx, y + dy);
      sum += hu, squares += hu * hu, count += 1;
    }
  const double mean = sum / count, sd = std::sqrt(std::max(0.0, squares / count - mean * mean));
  double level = 1;
  if (isFilled)
    level = std::clamp((mean - 60) / (kFilled_HU - 60), 0.0, 1.0);
  else if (mean < kUsual_HU)
    level = std::clamp((mean - kLowest_HU) / (kUsual_HU - kLowest_HU), 0.0, 1.0);
  else if (mean > kHighest_HU)
    level = std::clamp(1 - (mean - kHighest_HU) / 25, 0.0, 1.0);
  const double wanted = isFilled ? kFilledDrop_HU : kRimDrop_HU;
  double rim = 0;
  for (int ray = 0; ray < kRays; ++ray) {
    const double angle = 2 * std::numbers::pi * ray / kRays, c = std::cos(angle), s = std::sin(angle);
    double lowest = mean;
    for (double away = 0.75 * radius_mm; away <= 1.7 * radius_mm + 0.5; away += kPlace_mm / 2)
      lowest = std::min(lowest, double(valueAt(patch, x + c * away, y + s * away)));
    rim += std::min((mean - lowest) / wanted, 1.0) / kRays;
  }
  return level * rim * (1 - 0.6 * std::min(sd / kUneven_HU, 1.0));
}

using Places = std::vector<double>;  // kPlaces x kPlaces values

Places evidenceAround(const Patch& patch, double radius_mm, bool isFilled) {
  Places evidence(std::size_t(kPlaces) * kPlaces);
  for (int v = 0; v < kPlaces; ++v)
    for (int u = 0; u < kPlaces; ++u)
      for (const double size : {0.85, 1.15}) {
        double& best = evidence[std::size_t(v) * kPlaces + u];
        best = std::max(
            best, evidenceAt(patch, (u - kReach) * kPlace_mm, (v - kReach) * kPlace_mm, size * radius_mm, isFilled));
      }
  return evidence;
}

/// Cost of each place of a station.
Places costOf(const Places& evidence, const VesselStation& at, const TakenStation* taken) {
  constexpr double kOverlap = 12;
  Places cost(evidence.size());
  for (int v = 0; v < kPlaces; ++v)
    for (int u = 0; u < kPlaces; ++u) {
      const std::size_t place = std::size_t(v) * kPlaces + u;
      const double x = (u - kReach) * kPlace_mm, y = (v - kReach) * kPlace_mm;
      cost[place] = (x * x + y * y) / (2 * at.spread_mm * at.spread_mm) - kEvidence * evidence[place];
      if (!taken) continue;
      const Vec3 off = at.center_mm + Vec3{x, y, 0} - taken->center_mm;
      const double apart = 0.75 * (at.radius_mm + taken->radius_mm);
      cost[place] += kOverlap * std::max(0.0, 1 - std::hypot(off.x, off.y) / apart);
    }
  return cost;
}

const TakenStation* nearestLevel(const std::vector<TakenStation>& taken, double z_mm) {
  const TakenStation* nearest = nullptr;
  for (const TakenStation& one : taken)
    if (!nearest || std::abs(one.center_mm.z - z_mm) < std::abs(nearest->center_mm.z - z_mm)) nearest = &one;
  return nearest && std::abs(nearest->center_mm.z - z_mm) < 4 ? nearest : nullptr;
}

/// The places of the path with the least cost: dynamic programming from station to station.
std::vector<int> cheapestPath(const std::vector<Places>& costs) {
  std::vector<Places> sums = costs;
  std::vector<std::vector<int>> from(costs.size(), std::vector<int>(costs.front().size()));
  for (std::size_t n = 1; n < costs.size(); ++n)
    for (int v = 0; v < kPlaces; ++v)
      for (int u = 0; u < kPlaces; ++u) {
        const int place = v * kPlaces + u;
        double best = std::numeric_limits<double>::max();
        for (int b = std::max(0, v - kMaxShift); b <= std::min(kPlaces - 1, v + kMaxShift); ++b)
          for (int a = std::max(0, u - kMaxShift); a <= std::min(kPlaces - 1, u + kMaxShift); ++a) {
            const double sum = sums[n - 1][b * kPlaces + a] + kSmooth * ((a - u) * (a - u) + (b - v) * (b - v));
            if (sum < best) best = sum, from[n][place] = b * kPlaces + a;
          }
        sums[n][place] += best;
      }
  std::vector<int> path(costs.size());
  path.back() = int(std::ranges::min_element(sums.back()) - sums.back().begin());
  for (std::size_t n = costs.size() - 1; n > 0; --n) path[n - 1] = from[n][path[n]];
  return path;
}

}  // namespace

std::vector<FoundStation> searchedVessel(const CtVolume& ct, const std::vector<VesselStation>& expected, bool isFilled,
                                         const std::vector<TakenStation>& taken, Work& work) {
  const Transform indexFromPatient = ct.geometry.indexFromPatient();
  std::vector<Places> evidence(expected.size()), costs(expected.size());
  work.slices(int(expected.size()), [&](int n) {
    evidence[n] = evidenceAround(patchAt(ct, indexFromPatient, expected, n), expected[n].radius_mm, isFilled);
    costs[n] = costOf(evidence[n], expected[n], nearestLevel(taken, expected[n].center_mm.z));
  });
  std::vector<FoundStation> found;
  const auto path = cheapestPath(costs);
  for (std::size_t n = 0; n < expected.size(); ++n) {
    const Vec3 off{(path[n] % kPlaces - kReach) * kPlace_mm, (path[n] / kPlaces - kReach) * kPlace_mm, 0};
    found.push_back({expected[n].center_mm + off, evidence[n][path[n]]});
  }
  return found;
}

}  // namespace insonate::segmentation
