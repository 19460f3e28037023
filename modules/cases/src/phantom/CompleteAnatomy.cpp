#include "CompleteAnatomy.h"

#include "BodyHull.h"
#include "Noise.h"

#include <insonate/image/GaussianBlur.h>

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace insonate {
namespace {

constexpr double kMarrow_mm2 = 120;

Vec3 patientAt(const Transform& patientFromIndex, int i, int j, int k) {
  return patientFromIndex * Vec3{double(i), double(j), double(k)};
}

/// Distance to a tube's surface (negative inside), without the shape of its caps: segments with linear radius.
double tubeDistance_mm(const TubePlan& tube, Vec3 p_mm) {
  double nearest = 1e9;
  for (std::size_t n = 0; n + 1 < tube.knots.size(); ++n) {
    const auto& [a, ra] = tube.knots[n];
    const auto& [b, rb] = tube.knots[n + 1];
    const Vec3 along = b - a;
    const double t = std::clamp(dot(p_mm - a, along) / std::max(dot(along, along), 1e-9), 0.0, 1.0);
    nearest = std::min(nearest, norm(p_mm - a - along * t) - ra - (rb - ra) * t);
  }
  return nearest;
}

/// Share of structures around each voxel, which indicates nearby structures.
Volume<float> structureShare(const LabelMap& labels) {
  Volume<float> share(labels.geometry);
  std::transform(labels.voxels.begin(), labels.voxels.end(), share.voxels.begin(),
                 [](std::uint8_t label) { return label ? 1.f : 0.f; });
  blurGaussian(share, 0.9);
  return share;
}

/// Tissue between the structures of the deep neck: bundles of muscle, taller than wide, with connective tissue and some
/// fat between them.
std::uint8_t betweenStructures(Vec3 p_mm, std::uint32_t seed) {
  // Warped and rotated relative to the noise lattice, whose straight edges would be visible.
  const Vec3 cell = p_mm / 16;
  const double dx = 7 * phantom::smoothNoise(cell, seed ^ 0xb3dU), dy = 7 * phantom::smoothNoise(cell, seed ^ 0xb4dU);
  const double u = 0.8 * p_mm.x + 0.6 * p_mm.y + dx, v = 0.8 * p_mm.y - 0.6 * p_mm.x + dy;
  const Vec3 bundle{u / 21, v / 15, (p_mm.z + 0.3 * dx) / 55};
  const double a = phantom::smoothNoise(bundle, seed ^ 0xb0dU);
  const double b = phantom::smoothNoise(Vec3{v / 24, u / 18, p_mm.z / 60}, seed ^ 0xb1dU);
  // Boundaries of bundles: sign changes of either field.
  const double boundary = std::min(std::abs(a), std::abs(b));
  if (boundary < 0.07) return kSoftTissue;
  const double fat = phantom::smoothNoise(p_mm / 8, seed ^ 0xb2dU) + (boundary < 0.16 ? 0.25 : -0.35);
  return fat > 0.1 ? kFat : kMuscle;
}

}  // namespace

void fillMarrow(LabelMap& labels) {
  const VolumeGeometry& g = labels.geometry;
  const int width = g.size[0], height = g.size[1];
  const auto limit = static_cast<std::size_t>(kMarrow_mm2 / (g.spacing_mm.x * g.spacing_mm.y));
  tbb::parallel_for(0, g.size[2], [&](int k) {
    std::uint8_t* slice = &labels.at(0, 0, k);
    std::vector<char> seen(std::size_t(width) * height);
    std::vector<int> region;
    for (int start = 0; start < width * height; ++start) {
      if (seen[start] || slice[start]) continue;
      region.assign(1, start);
      seen[start] = 1;
      bool enclosed = true;
      for (std::size_t n = 0; n < region.size(); ++n) {
        const int i = region[n] % width, j = region[n] / width;
        if (i == 0 || j == 0 || i + 1 == width || j + 1 == height) {
          enclosed = false;
          continue;
        }
        for (const int next : {region[n] - 1, region[n] + 1, region[n] - width, region[n] + width}) {
          if (slice[next] == kBackground && !seen[next]) seen[next] = 1, region.push_back(next);
          enclosed = enclosed && (slice[next] == kBackground || slice[next] == kBone);
        }
      }
      if (enclosed && region.size() <= limit)
        for (const int voxel : region) slice[voxel] = kBone;
    }
  });
}

void drawTubes(LabelMap& labels, const std::vector<TubePlan>& tubes) {
  const Transform patientFromIndex = labels.geometry.patientFromIndex();
  const auto& size = labels.geometry.size;
  tbb::parallel_for(0, size[2], [&](int k) {
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        std::uint8_t& voxel = labels.at(i, j, k);
        if (voxel) continue;
        // Draws all lumens before any wall, so that tubes open into each other.
        std::uint8_t inside = kBackground, wall = kBackground;
        for (const TubePlan& tube : tubes) {
          const double d = tubeDistance_mm(tube, patientAt(patientFromIndex, i, j, k));
          if (d < 0 && !inside) inside = tube.label;
          if (d < tube.wall_mm && !wall) wall = tube.wall;
        }
        voxel = inside ? inside : wall;
      }
  });
}

Result<void> completeAnatomy(LabelMap& labels, const CompletionPlan& plan) {
  const VolumeGeometry& g = labels.geometry;
  if (std::abs(g.direction.column[2].z) < 0.9)
    return fail("A body can only be completed on axial slices; resample the label map to axial slices first.");
  if (std::all_of(labels.voxels.begin(), labels.voxels.end(), [](std::uint8_t v) { return v == 0; }))
    return fail("There is no structure in the label map (or in its cropped part) to build a body around.");
  const BodyHull hull(labels, plan.skin_mm + plan.fat_mm + plan.margin_mm);
  const Volume<float> share = structureShare(labels);
  const Transform patientFromIndex = g.patientFromIndex();
  // A sheet of a single voxel would break into steps where it is oblique.
  const double fascia_mm = std::max(0.8, 1.6 * std::max(g.spacing_mm.x, g.spacing_mm.y));
  tbb::parallel_for(0, g.size[2], [&](int k) {
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        std::uint8_t& voxel = labels.at(i, j, k);
        if (voxel) continue;
        const Vec3 p = patientAt(patientFromIndex, i, j, k);
        const double wave = phantom::smoothNoise(p / 21, plan.seed ^ 0x1f1U);
        const double depth = hull.depth_mm(i * g.spacing_mm.x, j * g.spacing_mm.y, k) + 1.2 * wave;
        const double fat = plan.fat_mm * (1 + 0.25 * phantom::smoothNoise(p / 17, plan.seed ^ 0x1f2U));
        if (depth <= 0) continue;
        if (depth < plan.skin_mm)
          voxel = kSkin;
        else if (depth < plan.skin_mm + fat)
          voxel = kFat;
        else if (depth < plan.skin_mm + fat + fascia_mm || share.at(i, j, k) > 0.04f)
          voxel = kSoftTissue;
        else
          voxel = betweenStructures(p, plan.seed);
      }
  });
  return {};
}

}  // namespace insonate
