#include "local/LabelDistances.h"

#include <insonate/haptics/TissueGrid.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

constexpr float kStep_mm = 0.01F, kMost_mm = 300;
constexpr std::size_t kMaxPoints = 40'000'000;

std::int16_t packed(float distance_mm) {
  return static_cast<std::int16_t>(std::lround(std::clamp(distance_mm, -kMost_mm, kMost_mm) / kStep_mm));
}

Result<void> checkSize(const VolumeGeometry& geometry) {
  if (auto ok = validate(geometry); !ok) return ok;
  if (geometry.voxelCount() > kMaxPoints)
    return fail("A grid of " + std::to_string(geometry.voxelCount()) +
                " points is too large for a needle's tissue; at most " + std::to_string(kMaxPoints) +
                " are held. Take a smaller part, or a coarser grid.");
  return {};
}

}  // namespace

TissueGrid::TissueGrid(const VolumeGeometry& geometry)
    : geometry_(geometry), indexFromPatient_(geometry.indexFromPatient()), points_(geometry.voxelCount()) {}

void TissueGrid::set(std::size_t offset, const TissueSample& sample) {
  Point& point = points_[offset];
  for (int w = 0; w < kNeedleWallCount; ++w) point.distance[w] = packed(sample.distance_mm[w]);
  point.label = sample.label;
}

Result<std::shared_ptr<const TissueGrid>> TissueGrid::make(const VolumeGeometry& geometry, const Sampler& sampler) {
  if (auto ok = checkSize(geometry); !ok) return tl::unexpected(ok.error());
  std::shared_ptr<TissueGrid> grid(new TissueGrid(geometry));
  const Transform patientFromIndex = geometry.patientFromIndex();
  for (int k = 0; k < geometry.size[2]; ++k)
    for (int j = 0; j < geometry.size[1]; ++j)
      for (int i = 0; i < geometry.size[0]; ++i)
        grid->set(geometry.offset(i, j, k), sampler(patientFromIndex * Vec3{double(i), double(j), double(k)}));
  return grid;
}

Result<std::shared_ptr<const TissueGrid>> TissueGrid::fromLabels(const LabelMap& labels, const Progress& progress) {
  if (auto ok = checkSize(labels.geometry); !ok) return tl::unexpected(ok.error());
  std::shared_ptr<TissueGrid> grid(new TissueGrid(labels.geometry));
  for (int w = 0; w < kNeedleWallCount; ++w) {
    const Label wall = kNeedleWalls[w];
    if (!report(progress, "Measuring the needle's tissue", double(w) / kNeedleWallCount))
      return fail(std::string(kCancelled));
    const auto distances = haptics::signedDistances(
        labels, [wall](std::uint8_t label) { return wall == kSkin ? label != kBackground : label == wall; });
    for (std::size_t i = 0; i < distances.size(); ++i) grid->points_[i].distance[w] = packed(distances[i]);
  }
  for (std::size_t i = 0; i < labels.voxels.size(); ++i) grid->points_[i].label = labels.voxels[i];
  return grid;
}

Result<std::shared_ptr<const TissueGrid>> TissueGrid::fromLabels(const LabelMap& labels, Vec3 center_mm,
                                                                 double reach_mm, const Progress& progress) {
  const VolumeGeometry& whole = labels.geometry;
  if (auto ok = validate(whole); !ok) return tl::unexpected(ok.error());
  if (!isFinite(center_mm) || !(reach_mm > 0))
    return fail("The center of the needle's tissue must be a finite point, and its reach must be above 0.");
  const Vec3 center = whole.indexFromPatient() * center_mm;
  std::array<int, 3> first{};
  LabelMap part;
  part.geometry = whole;
  for (int axis = 0; axis < 3; ++axis) {
    const double half = reach_mm / whole.spacing_mm[axis], last = whole.size[axis] - 1;
    const double from = std::ceil(std::max(center[axis] - half, 0.0)),
                 to = std::floor(std::min(center[axis] + half, last));
    if (from > to) return fail("The needle is outside the label map. Move it into the scan.");
    first[axis] = static_cast<int>(from);
    part.geometry.size[axis] = static_cast<int>(to - from) + 1;
  }
  part.geometry.origin_mm = whole.patientFromIndex() * Vec3{double(first[0]), double(first[1]), double(first[2])};
  part.voxels.resize(part.geometry.voxelCount());
  for (int k = 0; k < part.geometry.size[2]; ++k)
    for (int j = 0; j < part.geometry.size[1]; ++j)
      for (int i = 0; i < part.geometry.size[0]; ++i)
        part.at(i, j, k) = labels.at(first[0] + i, first[1] + j, first[2] + k);
  return fromLabels(part, progress);
}

TissueSample TissueGrid::at(Vec3 patient_mm) const noexcept {
  const Vec3 index = indexFromPatient_ * patient_mm;
  std::array<int, 3> low{}, next{}, nearest{};
  std::array<float, 3> share{};
  for (int axis = 0; axis < 3; ++axis) {
    const double last = geometry_.size[axis] - 1;
    // The comparison is also false for NaN.
    const double x = index[axis] > 0 ? std::min(index[axis], last) : 0;
    low[axis] = static_cast<int>(x);
    next[axis] = std::min(low[axis] + 1, geometry_.size[axis] - 1);
    share[axis] = static_cast<float>(x - low[axis]);
    nearest[axis] = share[axis] < 0.5F ? low[axis] : next[axis];
  }
  TissueSample sample;
  for (int corner = 0; corner < 8; ++corner) {
    const bool i = corner & 1, j = corner & 2, k = corner & 4;
    const float weight = (i ? share[0] : 1 - share[0]) * (j ? share[1] : 1 - share[1]) * (k ? share[2] : 1 - share[2]);
    const Point& point = points_[geometry_.offset(i ? next[0] : low[0], j ? next[1] : low[1], k ? next[2] : low[2])];
    for (int w = 0; w < kNeedleWallCount; ++w) sample.distance_mm[w] += weight * kStep_mm * point.distance[w];
  }
  sample.label = points_[geometry_.offset(nearest[0], nearest[1], nearest[2])].label;
  return sample;
}

Vec3 TissueGrid::outward(Vec3 patient_mm, int wall) const noexcept {
  const double h = 0.5 * std::min({geometry_.spacing_mm.x, geometry_.spacing_mm.y, geometry_.spacing_mm.z});
  const auto slope = [&](Vec3 step) {
    return static_cast<double>(at(patient_mm + step).distance_mm[wall] - at(patient_mm - step).distance_mm[wall]);
  };
  const Vec3 gradient{slope({h, 0, 0}), slope({0, h, 0}), slope({0, 0, h})};
  const double length = norm(gradient);
  return length > 1e-6 ? gradient / length : Vec3{};
}

}  // namespace insonate
