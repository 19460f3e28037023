#include "scene/VoxelBlend.h"

#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace insonate {
namespace {

/// Voxel rows around a row of nodes, one to four.
struct RowBlend {
  struct Row {
    std::size_t voxel;  ///< first voxel of the row
    float y, z;         ///< weights
  };
  std::array<Row, 4> row;
  int rows = 0;

  RowBlend(const VolumeGeometry& grid, const NodeLattice& lattice, int j, int k) {
    const NodeLattice::AxisNode y = lattice.at(1, j), z = lattice.at(2, k);
    for (int corner = 0; corner < 4; ++corner) {
      const float wy = corner & 1 ? y.weight : 1 - y.weight, wz = corner & 2 ? z.weight : 1 - z.weight;
      if (wy > 0 && wz > 0)
        row[rows++] = {grid.offset(0, corner & 1 ? y.high : y.low, corner & 2 ? z.high : z.low), wy, wz};
    }
  }
};

/// Calls visit(voxel, weight) for each voxel around a node.
template <class Visit>
void visitVoxels(const RowBlend& blend, const NodeLattice::AxisNode& x, const Visit& visit) {
  for (int r = 0; r < blend.rows; ++r) {
    const RowBlend::Row& row = blend.row[r];
    if (x.weight < 1) visit(row.voxel + x.low, (1 - x.weight) * row.y * row.z);
    if (x.weight > 0) visit(row.voxel + x.high, x.weight * row.y * row.z);
  }
}

std::vector<NodeLattice::AxisNode> nodesAlongX(const NodeLattice& lattice, const NodeBox& box) {
  std::vector<NodeLattice::AxisNode> nodes;
  for (int i = box.low[0]; i < box.high(0); ++i) nodes.push_back(lattice.at(0, i));
  return nodes;
}

std::uint8_t likeliest(const LabelMap& labels, const RowBlend& blend, const NodeLattice::AxisNode& x) {
  std::array<float, kLabelCount> weight{};
  visitVoxels(blend, x, [&](std::size_t voxel, float w) { weight[knownLabel(labels.voxels[voxel])] += w; });
  return static_cast<std::uint8_t>(std::max_element(weight.begin(), weight.end()) - weight.begin());
}

/// True if all voxels around a node have one label, as at nearly all nodes.
bool isUniform(const std::uint8_t* labels, const RowBlend& blend, const NodeLattice::AxisNode& x) {
  const std::uint8_t first = labels[blend.row[0].voxel + x.low];
  bool same = true;
  for (int r = 0; r < blend.rows; ++r)
    same = same && labels[blend.row[r].voxel + x.low] == first && labels[blend.row[r].voxel + x.high] == first;
  return same;
}

}  // namespace

void labelsOfNodes(const LabelMap& labels, const NodeLattice& lattice, const NodeBox& box,
                   std::span<std::uint8_t> out) {
  const auto along = nodesAlongX(lattice, box);
  for (int k = box.low[2]; k < box.high(2); ++k)
    for (int j = box.low[1]; j < box.high(1); ++j) {
      const RowBlend blend(labels.geometry, lattice, j, k);
      std::uint8_t* row = out.data() + box.offset(box.low[0], j, k);
      for (int i = 0; i < box.size[0]; ++i)
        row[i] = isUniform(labels.voxels.data(), blend, along[i])
                     ? std::uint8_t{knownLabel(labels.voxels[blend.row[0].voxel + along[i].low])}
                     : likeliest(labels, blend, along[i]);
    }
}

void deviationsOfNodes(const CtVolume& ct, const LabelMap& labels, const LabelMeans& mean_HU,
                       const NodeLattice& lattice, const NodeBox& box, std::span<std::int16_t> out) {
  const auto along = nodesAlongX(lattice, box);
  for (int k = box.low[2]; k < box.high(2); ++k)
    for (int j = box.low[1]; j < box.high(1); ++j) {
      const RowBlend blend(labels.geometry, lattice, j, k);
      std::int16_t* row = out.data() + box.offset(box.low[0], j, k);
      for (int i = 0; i < box.size[0]; ++i) {
        float deviation = 0;
        visitVoxels(blend, along[i], [&](std::size_t voxel, float w) {
          const double above = ct.voxels[voxel] - mean_HU[knownLabel(labels.voxels[voxel])];
          deviation += w * static_cast<float>(std::clamp(above, -300.0, 300.0));
        });
        row[i] = static_cast<std::int16_t>(deviation < 0 ? deviation - 0.5F : deviation + 0.5F);
      }
    }
}

}  // namespace insonate
