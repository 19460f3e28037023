#include "scene/TissueField.h"

#include "scene/DistanceTransform.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace insonate {
namespace {

struct Box {
  std::array<int, 3> low, high;  // voxels, inclusive
};

/// How the lattice cuts one axis of the label map: each voxel into parts, or several voxels into one node. One of the
/// two is 1.
struct AxisCut {
  int parts = 1, merged = 1;
  double nodesPerVoxel() const { return double(parts) / merged; }
};
using Cuts = std::array<AxisCut, 3>;

/// Nodes at most detail_mm apart. Finer voxels are merged for wide beams only, which could not tell.
Cuts cutsOf(const VolumeGeometry& grid, double detail_mm) {
  const double finest = std::min({grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z});
  const double target = finest / std::ceil(finest / detail_mm);
  Cuts cuts;
  for (int a = 0; a < 3; ++a) {
    cuts[a].parts = std::max(1, static_cast<int>(std::lround(grid.spacing_mm[a] / target)));
    if (detail_mm > AcousticScene::kFinestDetail_mm && cuts[a].parts == 1)
      cuts[a].merged = std::max(1, static_cast<int>(detail_mm / grid.spacing_mm[a]));
  }
  return cuts;
}

/// SD of the smoothing of outlines.
Vec3 smoothingOf(const VolumeGeometry& grid, const Cuts& cuts) {
  Vec3 sd_mm;
  for (int a = 0; a < 3; ++a) sd_mm[a] = std::min(1.2 * grid.spacing_mm[a] * cuts[a].merged, 2.0);
  return sd_mm;
}

/// Voxels of the label map that the region needs, with room for the reach of the distances and their smoothing; whole
/// nodes, so that nodes lie at the same places for every region.
Result<Box> voxelBox(const VolumeGeometry& grid, const Cuts& cuts, const Region& region) {
  const Transform indexFromPatient = grid.indexFromPatient();
  const Vec3 sd_mm = smoothingOf(grid, cuts);
  Vec3 low{1e30, 1e30, 1e30}, high{-1e30, -1e30, -1e30};
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p{corner & 1 ? region.high_mm.x : region.low_mm.x, corner & 2 ? region.high_mm.y : region.low_mm.y,
                 corner & 4 ? region.high_mm.z : region.low_mm.z};
    const Vec3 index = indexFromPatient * p;
    for (int a = 0; a < 3; ++a) low[a] = std::min(low[a], index[a]), high[a] = std::max(high[a], index[a]);
  }
  Box box;
  for (int a = 0; a < 3; ++a) {
    const double margin = (TissueField::kReach_mm + std::max(3.0, 5 * sd_mm[a])) / grid.spacing_mm[a];
    if (!(high[a] > -1) || !(low[a] < grid.size[a]))
      return fail("The imaging plane lies outside the CT; move the probe onto the patient.");
    const int merged = cuts[a].merged;
    box.low[a] = std::max(0, static_cast<int>(std::floor(low[a] - margin))) / merged * merged;
    box.high[a] = std::min(grid.size[a] - 1, static_cast<int>(std::ceil(high[a] + margin)));
  }
  return box;
}

/// Source voxel and weight of the next one, for each node along one axis. Nodes are the centres of the parts that each
/// voxel is cut into, so that none lies midway between two, where either label would be as likely; or of the voxels
/// merged into one.
struct AxisMap {
  std::vector<int> low, high;
  std::vector<float> weight;
};

AxisMap axisMap(int first, int nodes, const AxisCut& cut, int last) {
  AxisMap map;
  for (int n = 0; n < nodes; ++n) {
    const double at = first + (n + 0.5) / cut.nodesPerVoxel() - 0.5;
    const int low = static_cast<int>(std::floor(at));
    map.low.push_back(std::clamp(low, 0, last));
    map.high.push_back(std::clamp(low + 1, 0, last));
    map.weight.push_back(static_cast<float>(at - low));
  }
  return map;
}

template <class Visit>
void visitCorners(const std::array<AxisMap, 3>& maps, int i, int j, int k, const Visit& visit) {
  for (int corner = 0; corner < 8; ++corner) {
    const auto pick = [&](int axis, int n) {
      const AxisMap& m = maps[axis];
      return (corner >> axis) & 1 ? std::pair{m.high[n], m.weight[n]} : std::pair{m.low[n], 1 - m.weight[n]};
    };
    const auto [x, wx] = pick(0, i);
    const auto [y, wy] = pick(1, j);
    const auto [z, wz] = pick(2, k);
    const float w = wx * wy * wz;
    if (w > 0) visit(x, y, z, w);
  }
}

}  // namespace

std::array<double, kLabelCount> meanHuByLabel(const CtVolume& ct, const LabelMap& labels) {
  std::array<double, kLabelCount> sum{};
  std::array<std::size_t, kLabelCount> count{};
  for (std::size_t v = 0; v < labels.voxels.size(); ++v) {
    const int label = knownLabel(labels.voxels[v]);
    sum[label] += ct.voxels[v];
    ++count[label];
  }
  for (int l = 0; l < kLabelCount; ++l) sum[l] = count[l] ? sum[l] / static_cast<double>(count[l]) : 0;
  return sum;
}

Result<TissueField> makeTissueField(const CtVolume& ct, const LabelMap& labels, const Region& region, double detail_mm,
                                    const Progress& progress) {
  const VolumeGeometry& grid = labels.geometry;
  const Cuts cuts = cutsOf(grid, detail_mm);
  const auto box = voxelBox(grid, cuts, region);
  if (!box) return tl::unexpected(box.error());

  TissueField field;
  std::array<AxisMap, 3> maps;
  Vec3 nodeSpacing_mm;
  Transform nodeFromIndex;
  for (int a = 0; a < 3; ++a) {
    const AxisCut& cut = cuts[a];
    const int voxels = box->high[a] - box->low[a] + 1;
    field.size[a] = (voxels + cut.merged - 1) / cut.merged * cut.parts;
    maps[a] = axisMap(box->low[a], field.size[a], cut, grid.size[a] - 1);
    nodeSpacing_mm[a] = grid.spacing_mm[a] / cut.nodesPerVoxel();
    nodeFromIndex.linear.column[a] = nodeFromIndex.linear.column[a] * cut.nodesPerVoxel();
    nodeFromIndex.offset[a] = (0.5 - box->low[a]) * cut.nodesPerVoxel() - 0.5;
  }
  field.nodeFromPatient = nodeFromIndex * grid.indexFromPatient();
  const std::size_t nodes = field.offset(0, 0, field.size[2]);

  // Most likely label of each node; between slices of unlike spacing this is a linear blend of their outlines.
  std::vector<std::uint8_t> nodeLabel(nodes);
  field.ctDeviation.resize(nodes + TissueField::kPadding);
  const auto mean = meanHuByLabel(ct, labels);
  tbb::parallel_for(0, field.size[2], [&](int k) {
    for (int j = 0; j < field.size[1]; ++j)
      for (int i = 0; i < field.size[0]; ++i) {
        std::array<float, kLabelCount> weight{};
        float deviation = 0;
        visitCorners(maps, i, j, k, [&](int x, int y, int z, float w) {
          const std::size_t v = grid.offset(x, y, z);
          const int label = knownLabel(labels.voxels[v]);
          weight[label] += w;
          deviation += w * static_cast<float>(std::clamp(ct.voxels[v] - mean[label], -300.0, 300.0));
        });
        const std::size_t n = field.offset(i, j, k);
        nodeLabel[n] = static_cast<std::uint8_t>(std::max_element(weight.begin(), weight.end()) - weight.begin());
        field.ctDeviation[n] = static_cast<std::int16_t>(std::lround(deviation));
      }
  });

  std::array<bool, kLabelCount> present{};
  for (const std::uint8_t label : nodeLabel) present[label] = true;
  for (int l = 0; l < kLabelCount; ++l)
    if (present[l]) {
      if (l == kBackground) field.backgroundChannel = field.channels;
      field.label[field.channels++] = static_cast<std::uint8_t>(l);
    }

  Vec3 sp;
  for (int a = 0; a < 3; ++a) sp[a] = grid.spacing_mm[a] * cuts[a].merged;
  const double middle_mm = std::max(std::min(sp.x, sp.y), std::min(std::max(sp.x, sp.y), sp.z));
  if (!signedDistances(nodeLabel, nodeSpacing_mm, smoothingOf(grid, cuts), static_cast<float>(0.5 * middle_mm), field,
                       progress))
    return fail(std::string(kCancelled));
  return field;
}

}  // namespace insonate
