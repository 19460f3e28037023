#include "NeckFit.h"

#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace insonate::segmentation {
namespace {

constexpr double kFine_mm = 2.5, kFineBlur_mm = 1.5, kCoarseBlur_mm = 4;
constexpr double kFineStiff_mm = 4, kCoarseStiff_mm = 6;
constexpr int kFineRounds = 30, kCoarseRounds = 30, kLinearRounds = 10;
constexpr std::size_t kKept = 4;
constexpr double kWorse = 1.3;         // a neck that fits worse than the best by this factor is not used
constexpr double kBeyondNeck_mm = 20;  // of the part of the CT beyond the fitted neck that is examined

struct Corners {
  Vec3 low_mm, high_mm;
};

/// Box around the corners of a grid after a map.
template <class Map>
Corners cornersOf(const VolumeGeometry& g, const Map& map) {
  constexpr double kFar = std::numeric_limits<double>::max();
  Corners box{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
  const Transform patientFromIndex = g.patientFromIndex();
  for (int c = 0; c < 8; ++c) {
    const Vec3 corner = map(patientFromIndex * Vec3{(c & 1) ? g.size[0] - 0.5 : -0.5, (c & 2) ? g.size[1] - 0.5 : -0.5,
                                                    (c & 4) ? g.size[2] - 0.5 : -0.5});
    for (int axis = 0; axis < 3; ++axis) {
      box.low_mm[axis] = std::min(box.low_mm[axis], corner[axis]);
      box.high_mm[axis] = std::max(box.high_mm[axis], corner[axis]);
    }
  }
  return box;
}

struct CoarseNeck {
  CoarseImage fine, coarse;
};

/// A point of a fitted neck's vessel at a level of the CT; empty if the vessel does not reach the level.
std::optional<AtlasNeck::VesselPoint> pointAt(const std::vector<AtlasNeck::VesselPoint>& line, double z_mm) {
  for (std::size_t n = 0; n + 1 < line.size(); ++n) {
    const double before = line[n].position_mm.z - z_mm, behind = line[n + 1].position_mm.z - z_mm;
    if (before * behind > 0 || before == behind) continue;
    const double part = before / (before - behind);
    return AtlasNeck::VesselPoint{line[n].position_mm + (line[n + 1].position_mm - line[n].position_mm) * part,
                                  line[n].radius_mm + (line[n + 1].radius_mm - line[n].radius_mm) * part};
  }
  return std::nullopt;
}

std::vector<AtlasNeck::VesselPoint> fittedCourse(const FittedNeck& fitted, NeckStructure vessel) {
  std::vector<AtlasNeck::VesselPoint> course = fitted.neck->vessels[std::size_t(vessel)];
  const double size = std::cbrt(std::abs(determinant(fitted.map.linear.linear)));
  for (AtlasNeck::VesselPoint& point : course) point = {fitted.map(point.position_mm), point.radius_mm * size};
  return course;
}

/// Side of a muscle's voxel: that of the nearer jugular vein.
NeckStructure muscleAt(const AtlasNeck& neck, Vec3 at_mm) {
  const auto distance = [&](NeckStructure vessel) {
    double nearest = std::numeric_limits<double>::max();
    for (const AtlasNeck::VesselPoint& point : neck.vessels[std::size_t(vessel)])
      nearest = std::min(nearest, norm(point.position_mm - at_mm));
    return nearest;
  };
  return distance(NeckStructure::RightJugular) < distance(NeckStructure::LeftJugular)
             ? NeckStructure::RightSternocleidomastoid
             : NeckStructure::LeftSternocleidomastoid;
}

}  // namespace

std::vector<FittedNeck> fittedNecks(const CtVolume& ct, const LabelMap& automatic, std::span<const AtlasNeck> atlas,
                                    Work& work) {
  const Corners all = cornersOf(ct.geometry, [](Vec3 at_mm) { return at_mm; });
  const CoarseImage whole =
      blurred(coarseImage(ct, automatic, all.low_mm, all.high_mm, 2 * kFine_mm, work), kCoarseBlur_mm);
  std::vector<CoarseNeck> images;
  std::vector<std::size_t> order;
  std::vector<FittedNeck> fitted;
  for (const AtlasNeck& neck : atlas) {
    CoarseNeck image;
    image.fine = coarseImage(neck.labels, kFine_mm);
    image.coarse = blurred(halved(image.fine), kCoarseBlur_mm);
    image.fine = blurred(image.fine, kFineBlur_mm);
    auto map = placeNeck(whole, image.coarse, work);
    if (!map) continue;
    fitLinear(whole, image.coarse, *map, kLinearRounds);
    fitDisplacement(whole, image.coarse, *map, kCoarseRounds, kCoarseStiff_mm, work);
    order.push_back(fitted.size());
    images.push_back(std::move(image));
    fitted.push_back({&neck, std::move(*map)});
  }
  if (fitted.empty()) return {};
  std::ranges::sort(order, {}, [&](std::size_t n) { return fitted[n].map.mismatch; });
  const double best = fitted[order.front()].map.mismatch;
  std::erase_if(order, [&](std::size_t n) { return fitted[n].map.mismatch > kWorse * best; });
  order.resize(std::min(order.size(), kKept));

  Corners near = cornersOf(fitted[order.front()].neck->labels.geometry, fitted[order.front()].map);
  for (int axis = 0; axis < 3; ++axis) {
    near.low_mm[axis] = std::max(near.low_mm[axis] - kBeyondNeck_mm, all.low_mm[axis]);
    near.high_mm[axis] = std::min(near.high_mm[axis] + kBeyondNeck_mm, all.high_mm[axis]);
  }
  const CoarseImage part = blurred(coarseImage(ct, automatic, near.low_mm, near.high_mm, kFine_mm, work), kFineBlur_mm);
  std::vector<FittedNeck> kept;
  for (const std::size_t n : order) {
    fitDisplacement(part, images[n].fine, fitted[n].map, kFineRounds, kFineStiff_mm, work);
    kept.push_back(std::move(fitted[n]));
  }
  return kept;
}

std::vector<VesselStation> expectedCourse(const std::vector<FittedNeck>& necks, NeckStructure vessel,
                                          const VolumeGeometry& ct) {
  constexpr double kApart_mm = 1.5, kMinSpread_mm = 2, kEdge = 1;          // distance to the edge of the CT, in voxels
  constexpr double kArteryEnd_mm = 18, kVeinEnd_mm = 8, kUpperEnd_mm = 3;  // left out, since other vessels join there
  std::vector<std::vector<AtlasNeck::VesselPoint>> courses;
  double low = std::numeric_limits<double>::max(), high = -low;
  for (const FittedNeck& neck : necks) {
    courses.push_back(fittedCourse(neck, vessel));
    for (const auto& point : courses.back())
      low = std::min(low, point.position_mm.z), high = std::max(high, point.position_mm.z);
  }
  const Transform indexFromPatient = ct.indexFromPatient();
  std::vector<VesselStation> stations;
  low += labelOf(vessel) == kArtery ? kArteryEnd_mm : kVeinEnd_mm, high -= kUpperEnd_mm;
  for (double z = low; z <= high; z += kApart_mm) {
    std::vector<double> xs, ys, radii;
    for (const auto& course : courses)
      if (const auto point = pointAt(course, z)) {
        xs.push_back(point->position_mm.x), ys.push_back(point->position_mm.y), radii.push_back(point->radius_mm);
      }
    if (2 * xs.size() < courses.size()) continue;
    VesselStation station{{medianOf(xs), medianOf(ys), z}, kMinSpread_mm, medianOf(radii)};
    const Vec3 index = indexFromPatient * station.center_mm;
    bool isInside = true;
    for (int axis = 0; axis < 3; ++axis)
      isInside = isInside && index[axis] >= kEdge && index[axis] <= ct.size[axis] - 1 - kEdge;
    if (!isInside) continue;
    std::vector<double> away;
    for (std::size_t n = 0; n < xs.size(); ++n)
      away.push_back(std::hypot(xs[n] - station.center_mm.x, ys[n] - station.center_mm.y));
    station.spread_mm = std::hypot(kMinSpread_mm, medianOf(away));
    stations.push_back(station);
  }
  return stations;
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

double StructureShares::at(NeckStructure structure, Vec3 patient_mm) const {
  const auto& values = share[std::size_t(structure) - kNeckVessels];
  const Vec3 index = geometry.indexFromPatient() * patient_mm;
  int low[3];
  double part[3];
  for (int axis = 0; axis < 3; ++axis) {
    if (!(index[axis] >= 0 && index[axis] < geometry.size[axis] - 1)) return 0;
    low[axis] = static_cast<int>(index[axis]);
    part[axis] = index[axis] - low[axis];
  }
  double sum = 0;
  for (int c = 0; c < 8; ++c)
    sum += values[geometry.offset(low[0] + (c & 1), low[1] + ((c >> 1) & 1), low[2] + ((c >> 2) & 1))] *
           ((c & 1) ? part[0] : 1 - part[0]) * ((c & 2) ? part[1] : 1 - part[1]) * ((c & 4) ? part[2] : 1 - part[2]);
  return sum;
}

StructureShares structureShares(const std::vector<FittedNeck>& necks, Work& work) {
  constexpr double kSpacing_mm = 2;
  Corners box = cornersOf(necks.front().neck->labels.geometry, necks.front().map);
  StructureShares shares;
  for (int axis = 0; axis < 3; ++axis)
    shares.geometry.size[axis] = std::max(2, int((box.high_mm[axis] - box.low_mm[axis]) / kSpacing_mm));
  shares.geometry.spacing_mm = {kSpacing_mm, kSpacing_mm, kSpacing_mm};
  shares.geometry.origin_mm = box.low_mm;
  std::vector<float> all(shares.geometry.voxelCount());
  for (auto& share : shares.share) share.resize(all.size());
  for (const FittedNeck& fitted : necks) {
    const LabelMap& labels = fitted.neck->labels;
    const Transform neckFromIndex = labels.geometry.patientFromIndex();
    const Transform indexFromCt = shares.geometry.indexFromPatient();
    for (int k = 0; k < labels.geometry.size[2]; ++k) {
      work.checkpoint();
      for (int j = 0; j < labels.geometry.size[1]; ++j)
        for (int i = 0; i < labels.geometry.size[0]; ++i) {
          const std::uint8_t label = labels.at(i, j, k);
          if (label == kBackground) continue;
          const Vec3 at_mm = neckFromIndex * Vec3{double(i), double(j), double(k)};
          const Vec3 index = indexFromCt * fitted.map(at_mm);
          const int a = int(std::floor(index.x)), b = int(std::floor(index.y)), c = int(std::floor(index.z));
          if (!shares.geometry.contains(a, b, c) || !shares.geometry.contains(a + 1, b + 1, c + 1)) continue;
          std::vector<float>* share = nullptr;
          if (label == kThyroid) share = &shares.share[0];
          if (label == kSternocleidomastoid)
            share = &shares.share[std::size_t(muscleAt(*fitted.neck, at_mm)) - kNeckVessels];
          const double x = index.x - a, y = index.y - b, z = index.z - c;
          for (int corner = 0; corner < 8; ++corner) {
            const auto weight = static_cast<float>(((corner & 1) ? x : 1 - x) * ((corner & 2) ? y : 1 - y) *
                                                   ((corner & 4) ? z : 1 - z));
            const std::size_t v = shares.geometry.offset(a + (corner & 1), b + ((corner >> 1) & 1), c + (corner >> 2));
            all[v] += weight;
            if (share) (*share)[v] += weight;
          }
        }
    }
  }
  for (auto& share : shares.share)
    for (std::size_t v = 0; v < all.size(); ++v)
      if (all[v] > 0) share[v] /= all[v];
  return shares;
}

}  // namespace insonate::segmentation
