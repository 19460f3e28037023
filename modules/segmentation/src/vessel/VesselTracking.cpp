#include "BloodLevel.h"
#include "Guarded.h"
#include "LumenFill.h"
#include "OutlineFit.h"
#include "SectionLine.h"
#include "SectionShape.h"
#include "Work.h"
#include "tools/SeedFront.h"

#include <insonate/segmentation/VesselTracking.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace insonate::segmentation {
namespace {

constexpr double kAside_mm = 25;  // a vessel does not swerve farther from the line between two clicks
constexpr double kStepsPerMm = 16, kUnlikeBlood = 8;

/// The way from one point in blood to another that stays in blood as long as it can, patient mm, from voxel to voxel.
std::vector<Vec3> pathThroughBlood(const CtVolume& ct, Vec3 from_mm, Vec3 to_mm, const BloodLevel& level, Work& work) {
  const VoxelBox box = boxAround(ct.geometry, std::array{from_mm, to_mm}, kAside_mm);
  const VolumeGeometry part = gridOf(ct.geometry, box);
  const Transform indexFromPatient = part.indexFromPatient(), patientFromIndex = part.patientFromIndex();
  const auto [fi, fj, fk] = nearestVoxel(indexFromPatient * from_mm);
  const auto [ti, tj, tk] = nearestVoxel(indexFromPatient * to_mm);

  Proposal front{box, Volume<std::uint8_t>(part, Proposal::kKeep)};
  front.labels.at(fi, fj, fk) = 1;
  Selection everywhere(ct.geometry, box);
  std::ranges::fill(everywhere.mask.voxels, std::uint8_t{1});
  const CtVolume hu = cropped(ct, box);
  SeedFront run(front, everywhere);
  run.run(work, [&](std::uint32_t cost, std::uint32_t, std::uint32_t to, int axis) {
    const double perMm = 1 + kUnlikeBlood * level.unlikeness(hu.voxels[to]);
    const auto step = static_cast<std::uint32_t>(kStepsPerMm * perMm * part.spacing_mm[axis]);
    return cost + std::clamp(step, 1U, SeedFront::kBuckets - 1);
  });

  // Back to where it began, each step to the neighbor that was reached at the least cost.
  std::vector<Vec3> path;
  std::array at{ti, tj, tk};
  while (true) {
    path.push_back(patientFromIndex * Vec3{double(at[0]), double(at[1]), double(at[2])});
    const std::array here = at;
    std::uint32_t least = run.cost(part.offset(here[0], here[1], here[2]));
    if (least == 0) break;
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) {
        std::array next = here;
        next[axis] += step;
        if (!part.contains(next[0], next[1], next[2])) continue;
        const std::uint32_t cost = run.cost(part.offset(next[0], next[1], next[2]));
        if (cost < least) least = cost, at = next;
      }
  }
  std::ranges::reverse(path);
  return path;
}

}  // namespace
}  // namespace insonate::segmentation

namespace insonate {
namespace {

using segmentation::BloodLevel;
using segmentation::OutlineFit;
using segmentation::Radii;
using segmentation::SectionShape;
using segmentation::Work;

constexpr int kCenterd = 4;  // iterations that lead from the edge of a flat vein to its center
constexpr int kSmoothPath = 4, kSmoothLine = 3, kSmoothShape = 5;  // stations on both sides
constexpr int kLikeNeighbors = 4;                                  // stations whose median is the expected outline
constexpr int kCalibre = 15;  // stations whose median is the vessel's usual area here
constexpr int kEven = 1;      // stations whose median is the refined outline
constexpr double kOpens = 2;  // times the usual area: the section opens into another vessel
constexpr double kMinContrast_HU = 40;
constexpr double kAround_mm = 30;

/// Stations at which sections of a vessel are taken, and the level of its blood there.
struct Stations {
  std::vector<Vec3> line;
  std::vector<BloodLevel> levels;
};

Stations pathThrough(const CtVolume& ct, std::span<const Vec3> clicks_mm, double reach_mm, Work& work) {
  Stations stations;
  std::vector<std::size_t> clicks{0};
  BloodLevel from = segmentation::bloodAt(ct, clicks_mm[0], reach_mm);
  for (std::size_t n = 1; n < clicks_mm.size(); ++n) {
    const BloodLevel to = segmentation::bloodAt(ct, clicks_mm[n], reach_mm);
    const auto path = segmentation::pathThroughBlood(ct, clicks_mm[n - 1], clicks_mm[n], mixed(from, to, 0.5), work);
    const auto line = segmentation::resampled(segmentation::smoothed(path, kSmoothPath));
    stations.line.insert(stations.line.end(), line.begin() + (n > 1), line.end());
    clicks.push_back(stations.line.size() - 1);
    from = to;
  }
  const auto levels = segmentation::levelsAtClicks(ct, clicks_mm, stations.line, clicks, reach_mm, work);
  stations.levels.push_back(levels.front());
  for (std::size_t n = 1; n < clicks.size(); ++n)
    for (std::size_t m = clicks[n - 1] + 1; m <= clicks[n]; ++m)
      stations.levels.push_back(
          mixed(levels[n - 1], levels[n], double(m - clicks[n - 1]) / double(clicks[n] - clicks[n - 1])));
  return stations;
}

/// A section that opens into another vessel extends into it, and takes the outline of the nearest section that does
/// not.
void closeOrigins(std::vector<VesselOutline>& sections) {
  const int count = static_cast<int>(sections.size());
  std::vector<double> areas, around;
  for (const VesselOutline& section : sections) areas.push_back(section.area_mm2());
  std::vector<bool> open;
  for (int n = 0; n < count; ++n) {
    around.assign(areas.begin() + std::max(0, n - kCalibre), areas.begin() + std::min(count, n + kCalibre + 1));
    const auto middle = around.begin() + std::ptrdiff_t(around.size() / 2);
    std::ranges::nth_element(around, middle);
    open.push_back(areas[n] > kOpens * *middle);
  }
  for (int n = 0; n < count; ++n)
    for (int away = 1; open[n] && away <= kCalibre; ++away) {
      const int before = n - away, behind = n + away;
      const int nearest = before >= 0 && !open[before] ? before : behind < count && !open[behind] ? behind : -1;
      if (nearest < 0) continue;
      sections[n].radius_mm = sections[nearest].radius_mm;
      break;
    }
}

TrackedVessel track(const CtVolume& ct, Stations stations, const VesselTracking& how, Work& work) {
  work.start("Finding the vessel's wall");
  const OutlineFit wall(ct, how.largest_mm);
  std::vector<SectionShape> shapes(stations.line.size());
  const auto forAll = [&](std::vector<VesselOutline>& sections, const auto& radiiOf) {
    std::vector<Radii> radii(sections.size());
    work.slices(static_cast<int>(sections.size()), [&](int n) { radii[n] = radiiOf(n); });
    for (std::size_t n = 0; n < sections.size(); ++n) sections[n].radius_mm = radii[n];
  };
  const auto fitAll = [&](const std::vector<Radii>* expected) {
    std::vector<VesselOutline> sections = segmentation::sectionsAlong(stations.line);
    forAll(sections, [&](int n) {
      return wall.fitted(sections, n, shapes[n], stations.levels[n], expected ? &(*expected)[n] : nullptr);
    });
    closeOrigins(sections);
    return sections;
  };
  for (int pass = 0; pass < kCenterd; ++pass) {
    const auto sections = fitAll(nullptr);
    std::vector<segmentation::SectionMoments> moments;
    std::vector<double> blood_HU;
    for (std::size_t n = 0; n < sections.size(); ++n) {
      blood_HU.push_back(wall.bloodIn(sections[n], shapes[n]));
      const auto& m = moments.emplace_back(shapes[n].momentsOf(sections[n].radius_mm));
      stations.line[n] = sections[n].center_mm + sections[n].right * m.x + sections[n].down * m.y;
    }
    stations.line = segmentation::smoothed(stations.line, kSmoothLine);
    stations.levels = segmentation::measured(stations.levels, blood_HU);
    for (std::size_t n = 0; n < sections.size(); ++n)
      shapes[n] = SectionShape(segmentation::meanMoments(moments, int(n), kSmoothShape));
  }
  const auto expected = segmentation::likeNeighbors(fitAll(nullptr), kLikeNeighbors);
  TrackedVessel vessel;
  vessel.outlines = fitAll(&expected);
  forAll(vessel.outlines, [&](int n) { return wall.refined(vessel.outlines, n, shapes[n], stations.levels[n]); });
  const auto even = segmentation::likeNeighbors(vessel.outlines, kEven);
  for (std::size_t n = 0; n < vessel.outlines.size(); ++n)
    vessel.outlines[n].radius_mm = shapes[n].unstretched(even[n]);
  vessel.line = stations.line;
  return vessel;
}

}  // namespace

double VesselOutline::area_mm2() const {
  double twice = 0;
  for (int n = 0; n < VesselOutline::kRays; ++n) twice += radius_mm[n] * radius_mm[(n + 1) % VesselOutline::kRays];
  return twice * std::sin(2 * std::numbers::pi / VesselOutline::kRays) / 2;
}

Result<TrackedVessel> trackVessel(const CtVolume& ct, std::span<const Vec3> clicks_mm, const VesselTracking& how,
                                  const Progress& progress) {
  if (auto ok = segmentation::checkClicks(ct, clicks_mm); !ok) return tl::unexpected(ok.error());
  return segmentation::guarded([&]() -> Result<TrackedVessel> {
    const auto around = boxAround(ct.geometry, clicks_mm, kAround_mm);
    const CtVolume near = segmentation::blurredPart(ct, around, how.smoothing_mm);
    for (const Vec3& click_mm : clicks_mm) {
      const BloodLevel level = segmentation::bloodAt(near, click_mm, how.largest_mm);
      if (2 * (level.blood_HU - level.half_HU) < kMinContrast_HU)
        return fail("There is no contrast between vessel and tissue at a click (" +
                    std::to_string(std::lround(level.blood_HU)) +
                    " HU); click in blood with contrast agent, or draw the vessel and fill between slices.");
    }
    Work work(progress, kCenterd + 5 + 1.1 * double(clicks_mm.size()));
    work.start("Following the vessel");
    TrackedVessel vessel = track(cropped(ct, around), pathThrough(near, clicks_mm, how.largest_mm, work), how, work);
    vessel.lumen = segmentation::fillLumen(ct.geometry, vessel.outlines);
    return vessel;
  });
}

}  // namespace insonate
