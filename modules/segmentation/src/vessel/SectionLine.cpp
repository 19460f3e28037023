#include "SectionLine.h"

#include <insonate/image/GaussianBlur.h>

#include <algorithm>
#include <cmath>

namespace insonate::segmentation {
namespace {

constexpr double kStation_mm = 1;

/// Minimum distance between clicks. Clicks in neighboring slices are far enough apart where slices are thick.
double minBetweenClicks_mm(const Vec3& spacing_mm) {
  constexpr double kUsual_mm = 5, kFine_mm = 2.5, kTolerance = 0.95;
  return std::clamp(kTolerance * std::max({spacing_mm.x, spacing_mm.y, spacing_mm.z}), kFine_mm, kUsual_mm);
}

}  // namespace

std::vector<Vec3> smoothed(const std::vector<Vec3>& line, int reach) {
  std::vector<Vec3> smooth(line.size());
  const int count = static_cast<int>(line.size());
  for (int n = 0; n < count; ++n) {
    const int here = std::min({reach, n, count - 1 - n});
    for (int m = n - here; m <= n + here; ++m) smooth[n] = smooth[n] + line[m] / (2.0 * here + 1);
  }
  return smooth;
}

std::vector<Vec3> resampled(const std::vector<Vec3>& line) {
  std::vector<Vec3> points{line.front()};
  double left_mm = kStation_mm;
  for (std::size_t n = 1; n < line.size(); ++n) {
    Vec3 from = line[n - 1];
    for (double length = norm(line[n] - from); length >= left_mm; length = norm(line[n] - from)) {
      from = from + (line[n] - from) * (left_mm / length);
      points.push_back(from);
      left_mm = kStation_mm;
    }
    left_mm -= norm(line[n] - from);
  }
  if (norm(points.back() - line.back()) > kStation_mm / 4) points.push_back(line.back());
  return points;
}

std::vector<VesselOutline> sectionsAlong(const std::vector<Vec3>& line) {
  constexpr std::size_t kBaseline = 3;
  std::vector<VesselOutline> sections(line.size());
  Vec3 right{1, 0, 0};
  for (std::size_t n = 0; n < line.size(); ++n) {
    const std::size_t on = std::min(n + kBaseline, line.size() - 1), back = n > kBaseline ? n - kBaseline : 0;
    const Vec3 axis = normalized(line[on] - line[back]);
    if (n == 0 && std::abs(axis.x) > 0.9) right = {0, 1, 0};
    right = normalized(right - axis * dot(right, axis));
    sections[n].center_mm = line[n];
    sections[n].right = right;
    sections[n].down = cross(axis, right);
  }
  return sections;
}

CtVolume blurredPart(const CtVolume& ct, const VoxelBox& box, double sigma_mm) {
  CtVolume part = cropped(ct, box);
  if (sigma_mm <= 0) return part;
  Volume<float> smooth;
  smooth.geometry = part.geometry;
  smooth.voxels.assign(part.voxels.begin(), part.voxels.end());
  blurGaussian(smooth, sigma_mm);
  std::ranges::transform(smooth.voxels, part.voxels.begin(),
                         [](float hu) { return static_cast<std::int16_t>(std::lround(hu)); });
  return part;
}

Result<void> checkClicks(const CtVolume& ct, std::span<const Vec3> clicks_mm) {
  if (clicks_mm.size() < 2) return fail("Tracking a vessel needs at least two clicks. Click along the vessel.");
  for (std::size_t n = 1; n < clicks_mm.size(); ++n)
    if (norm(clicks_mm[n] - clicks_mm[n - 1]) < minBetweenClicks_mm(ct.geometry.spacing_mm))
      return fail(
          "Two clicks are almost at the same point. Click along the vessel, at least 5 mm apart or in different "
          "slices.");
  const Transform indexFromPatient = ct.geometry.indexFromPatient();
  for (const Vec3& click_mm : clicks_mm)
    if (const auto [i, j, k] = nearestVoxel(indexFromPatient * click_mm); !ct.geometry.contains(i, j, k))
      return fail("A click lies outside the CT. Click in the vessel.");
  return {};
}

}  // namespace insonate::segmentation
