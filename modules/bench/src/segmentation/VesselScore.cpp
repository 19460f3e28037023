#include "VesselScore.h"

#include <insonate/segmentation/Score.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

namespace insonate::bench {
namespace {

constexpr std::uint8_t kVessel = 1;

/// Works on the grid of a box around the shape.
LabelMap placed(const Selection& shape, const VolumeGeometry& geometry, const VoxelBox& box) {
  LabelMap map(gridOf(geometry, box));
  for (int k = 0; k < box.length(2); ++k)
    for (int j = 0; j < box.length(1); ++j)
      for (int i = 0; i < box.length(0); ++i)
        if (shape.isSelected(box.first[0] + i, box.first[1] + j, box.first[2] + k)) map.at(i, j, k) = kVessel;
  return map;
}

/// Tells whether only the label lies between a point and the nearest point of the center line.
bool seesMiddle(const LabelMap& labels, std::uint8_t label, Vec3 point_mm, const CenterLine& line) {
  const Vec3 middle_mm = *std::ranges::min_element(line, {}, [&](Vec3 m) { return norm(m - point_mm); });
  const Transform indexFromPatient = labels.geometry.indexFromPatient();
  const Vec3& s = labels.geometry.spacing_mm;
  const int steps = static_cast<int>(std::ceil(norm(middle_mm - point_mm) / (std::min({s.x, s.y, s.z}) / 2)));
  for (int n = 1; n < steps; ++n) {
    const auto [i, j, k] = nearestVoxel(indexFromPatient * (point_mm + (middle_mm - point_mm) * (double(n) / steps)));
    if (labels.at(i, j, k) != label) return false;
  }
  return true;
}

}  // namespace

Result<std::vector<TrueVessel>> trueVessels(const LabelMap& labels, std::uint8_t label, std::size_t most,
                                            double shortest_mm, const Progress& progress) {
  auto lines = centerLines(labels, label, progress);
  if (!lines) return tl::unexpected(lines.error());
  const VoxelBox box = boundingBoxOf(labels, label);
  std::vector<TrueVessel> vessels;
  for (CenterLine& line : *lines)
    vessels.push_back({std::move(line), Selection(labels.geometry, box), voxelsOf(labels, label, box)});
  const Transform patientFromIndex = labels.geometry.patientFromIndex();
  for (int k = box.first[2]; k < box.end[2]; ++k)
    for (int j = box.first[1]; j < box.end[1]; ++j)
      for (int i = box.first[0]; i < box.end[0]; ++i) {
        if (labels.at(i, j, k) != label) continue;
        const Vec3 p = patientFromIndex * Vec3{double(i), double(j), double(k)};
        const auto nearest = std::ranges::min_element(vessels, {}, [&](const TrueVessel& vessel) {
          return *distanceToCenterLine_mm(std::span(&vessel.line, 1), p);
        });
        if (nearest == vessels.end() || !seesMiddle(labels, label, p, nearest->line)) continue;
        nearest->voxels.mask.at(i - box.first[0], j - box.first[1], k - box.first[2]) = 1;
        nearest->others.mask.at(i - box.first[0], j - box.first[1], k - box.first[2]) = 0;
      }
  std::erase_if(vessels, [&](const TrueVessel& v) { return double(v.line.size()) < shortest_mm; });
  std::ranges::stable_sort(vessels, std::greater<>(), [](const TrueVessel& v) { return v.voxels.count(); });
  vessels.resize(std::min(vessels.size(), most));
  return vessels;
}

Selection without(Selection shape, const Selection& others) {
  const VoxelBox& box = shape.box;
  for (int k = box.first[2]; k < box.end[2]; ++k)
    for (int j = box.first[1]; j < box.end[1]; ++j)
      for (int i = box.first[0]; i < box.end[0]; ++i)
        if (others.isSelected(i, j, k)) shape.mask.at(i - box.first[0], j - box.first[1], k - box.first[2]) = 0;
  return shape;
}

Selection betweenEnds(const Selection& shape, const CenterLine& line) {
  Selection part = shape;
  const Transform patientFromIndex = shape.mask.geometry.patientFromIndex();
  const std::size_t inward = std::min<std::size_t>(4, line.size() - 1);
  const Vec3 first = line[inward] - line.front(), last = line[line.size() - 1 - inward] - line.back();
  const auto& size = shape.mask.geometry.size;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        const Vec3 p = patientFromIndex * Vec3{double(i), double(j), double(k)};
        if (dot(p - line.front(), first) < 0 || dot(p - line.back(), last) < 0) part.mask.at(i, j, k) = 0;
      }
  return part;
}

Result<SegmentationScoreRow> scoreClicks(const CtVolume& ct, const TrueVessel& truth, int clicks,
                                         const VesselTracking& how, SegmentationScoreRow row,
                                         const Progress& progress) {
  std::vector<Vec3> clicks_mm;
  for (int n = 0; n < clicks; ++n)
    clicks_mm.push_back(truth.line[(truth.line.size() - 1) * std::size_t(n) / std::size_t(clicks - 1)]);
  row.clicks = clicks;
  const auto tracked = trackVessel(ct, clicks_mm, how, progress);
  if (!tracked) {
    if (tracked.error().message == kCancelled) return tl::unexpected(tracked.error());
    return row;
  }
  const VoxelBox box = united(tracked->lumen.box, truth.voxels.box);
  const auto scores =
      scoreLabels(placed(betweenEnds(without(tracked->lumen, truth.others), truth.line), ct.geometry, box),
                  placed(betweenEnds(truth.voxels, truth.line), ct.geometry, box), {kVessel}, progress);
  if (!scores) return tl::unexpected(scores.error());
  row.dice = scores->front().dice;
  row.meanSurface_mm = scores->front().meanSurface_mm, row.p95Surface_mm = scores->front().p95Surface_mm;
  return row;
}

}  // namespace insonate::bench
