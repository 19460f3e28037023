#include "scene/NodeLattice.h"

#include "scene/TissueField.h"

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

/// Margin, since engines interpolate on lattices that extend a little beyond a frame.
constexpr double kBeyond_mm = 2;
/// Margins for the smoothing of outlines, in SDs of its Gaussian.
constexpr double kFullMargin_SD = 10, kCoarseMargin_SD = 4;

/// Voxels finer than the detail are merged only for wide beams, which cannot resolve them.
std::array<NodeLattice::AxisCut, 3> cutsOf(const VolumeGeometry& grid, double detail_mm) {
  const double finest = std::min({grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z});
  const double target = finest / std::ceil(finest / detail_mm);
  std::array<NodeLattice::AxisCut, 3> cuts;
  for (int a = 0; a < 3; ++a) {
    cuts[a].parts = std::max(1, static_cast<int>(std::lround(grid.spacing_mm[a] / target)));
    if (detail_mm > AcousticScene::kFinestDetail_mm && cuts[a].parts == 1)
      cuts[a].merged = std::max(1, static_cast<int>(detail_mm / grid.spacing_mm[a]));
  }
  return cuts;
}

/// Voxels are divided or merged, along each axis by itself.
std::array<NodeLattice::AxisCut, 3> coarseCutsOf(const VolumeGeometry& grid) {
  std::array<NodeLattice::AxisCut, 3> cuts;
  for (int a = 0; a < 3; ++a) {
    cuts[a].parts = std::max(1, static_cast<int>(std::lround(grid.spacing_mm[a] / NodeLattice::kCoarse_mm)));
    cuts[a].merged = std::max(1, static_cast<int>(std::lround(NodeLattice::kCoarse_mm / grid.spacing_mm[a])));
  }
  return cuts;
}

}  // namespace

NodeBox grown(const NodeBox& box, const std::array<int, 3>& margin, const NodeBox& limit) {
  NodeBox result = box;
  for (int a = 0; a < 3; ++a) result.low[a] -= margin[a], result.size[a] += 2 * margin[a];
  return overlap(result, limit);
}

NodeBox overlap(const NodeBox& a, const NodeBox& b) {
  NodeBox both;
  for (int axis = 0; axis < 3; ++axis) {
    both.low[axis] = std::max(a.low[axis], b.low[axis]);
    both.size[axis] = std::max(0, std::min(a.high(axis), b.high(axis)) - both.low[axis]);
  }
  return both;
}

NodeBox cubesOf(const NodeBox& box, int edge) {
  NodeBox cubes;
  for (int a = 0; a < 3; ++a) {
    cubes.low[a] = box.low[a] / edge;
    cubes.size[a] = (box.high(a) + edge - 1) / edge - cubes.low[a];
  }
  return cubes;
}

NodeLattice::NodeLattice(const VolumeGeometry& grid, double detail_mm) : NodeLattice(grid, cutsOf(grid, detail_mm)) {}

NodeLattice NodeLattice::coarse(const VolumeGeometry& grid) {
  NodeLattice lattice(grid, coarseCutsOf(grid));
  lattice.setMargin(kCoarseMargin_SD);
  return lattice;
}

void NodeLattice::setMargin(double smoothing_SD) {
  for (int a = 0; a < 3; ++a) smoothed[a] = static_cast<int>(std::ceil(smoothing_SD * smoothing_mm[a] / spacing_mm[a]));
}

NodeLattice::NodeLattice(const VolumeGeometry& grid, const std::array<AxisCut, 3>& axisCuts)
    : cuts(axisCuts), voxels(grid.size) {
  Transform nodeFromIndex;
  Vec3 merged_mm;
  for (int a = 0; a < 3; ++a) {
    const AxisCut& cut = cuts[a];
    size[a] = (voxels[a] + cut.merged - 1) / cut.merged * cut.parts;
    spacing_mm[a] = grid.spacing_mm[a] / cut.nodesPerVoxel();
    nodeFromIndex.linear.column[a] = nodeFromIndex.linear.column[a] * cut.nodesPerVoxel();
    nodeFromIndex.offset[a] = 0.5 * cut.nodesPerVoxel() - 0.5;
    merged_mm[a] = grid.spacing_mm[a] * cut.merged;
    smoothing_mm[a] = std::min(1.2 * merged_mm[a], 2.0);
    reach[a] = static_cast<int>(std::ceil(TissueField::kReach_mm / spacing_mm[a]));
  }
  nodeFromPatient = nodeFromIndex * grid.indexFromPatient();
  setMargin(kFullMargin_SD);
  const auto [x, y, z] = merged_mm;
  freedom_mm = 0.5 * std::max(std::min(x, y), std::min(std::max(x, y), z));
}

NodeBox NodeLattice::boxOf(const Region& region) const {
  NodeBox box;
  Vec3 low{1e30, 1e30, 1e30}, high{-1e30, -1e30, -1e30};
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p{corner & 1 ? region.high_mm.x : region.low_mm.x, corner & 2 ? region.high_mm.y : region.low_mm.y,
                 corner & 4 ? region.high_mm.z : region.low_mm.z};
    const Vec3 node = nodeFromPatient * p;
    for (int a = 0; a < 3; ++a) low[a] = std::min(low[a], node[a]), high[a] = std::max(high[a], node[a]);
  }
  for (int a = 0; a < 3; ++a) {
    if (!(high[a] > -1) || !(low[a] < size[a])) return {};
    const double beyond = kBeyond_mm / spacing_mm[a] + 1;
    const double first = std::clamp(std::floor(low[a] - beyond), 0.0, size[a] - 1.0);
    const double last = std::clamp(std::ceil(high[a] + beyond), 0.0, size[a] - 1.0);
    box.low[a] = static_cast<int>(first);
    box.size[a] = static_cast<int>(last - first) + 1;
  }
  return box;
}

NodeBox NodeLattice::voxelsOf(const NodeBox& nodes) const {
  NodeBox box;
  for (int a = 0; a < 3; ++a) {
    box.low[a] = at(a, nodes.low[a]).low;
    box.size[a] = at(a, nodes.high(a) - 1).high - box.low[a] + 1;
  }
  return box;
}

std::int16_t NodeLattice::farUnits() const {
  // Distances are between node centers; the boundary is half a node closer.
  const double far_mm = TissueField::kReach_mm - (spacing_mm.x + spacing_mm.y + spacing_mm.z) / 6;
  return static_cast<std::int16_t>(std::lround(far_mm * TissueField::kUnitsPerMm));
}

/// Nodes are the centers of the parts into which each voxel is divided, so that no node is midway between two voxels
/// with equally likely labels; or the centers of the voxels merged into one.
NodeLattice::AxisNode NodeLattice::at(int axis, int node) const {
  const double index = (node + 0.5) / cuts[axis].nodesPerVoxel() - 0.5;
  const int low = static_cast<int>(std::floor(index)), last = voxels[axis] - 1;
  return {std::clamp(low, 0, last), std::clamp(low + 1, 0, last), static_cast<float>(index - low)};
}

}  // namespace insonate
