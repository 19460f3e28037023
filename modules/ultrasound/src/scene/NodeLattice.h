#pragma once

#include <insonate/core/Transform.h>
#include <insonate/image/VolumeGeometry.h>
#include <insonate/ultrasound/AcousticScene.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace insonate {

/// Called now and then by long work, on its threads: true if the result is no longer needed. May be empty.
using Stopped = std::function<bool()>;

/// A box of whole nodes or voxels.
struct NodeBox {
  std::array<int, 3> low{}, size{};

  int high(int axis) const { return low[axis] + size[axis]; }  ///< the first beyond
  std::size_t count() const { return std::size_t(size[0]) * size[1] * size[2]; }
  std::size_t offset(int i, int j, int k) const {
    return (std::size_t(k - low[2]) * size[1] + (j - low[1])) * size[0] + (i - low[0]);
  }
};

/// This much larger each way, but not beyond `limit`.
NodeBox grown(const NodeBox& box, const std::array<int, 3>& margin, const NodeBox& limit);
NodeBox overlap(const NodeBox& a, const NodeBox& b);
/// Cubes with edges of `edge` nodes, counted from node 0, that a box touches; in cubes.
NodeBox cubesOf(const NodeBox& box, int edge);

/// Positions of the nodes of a patient's distances: each voxel cut into equal parts, or several merged. Does not
/// depend on a region.
struct NodeLattice {
  /// Division of one axis of the label map. One of the two is 1.
  struct AxisCut {
    int parts = 1, merged = 1;
    double nodesPerVoxel() const { return double(parts) / merged; }
  };
  /// The two voxels whose blend a node is; one and the same at the volume's edge.
  struct AxisNode {
    int low, high;
    float weight;  ///< of the high one
  };

  /// Nodes are at most detail_mm apart.
  NodeLattice(const VolumeGeometry& grid, double detail_mm);

  NodeBox whole() const { return {{}, size}; }
  /// Nodes round a region, and a little more, as far as there are any; empty where the region misses the volume.
  NodeBox boxOf(const Region& region) const;
  /// Voxels that decide on a box of nodes.
  NodeBox voxelsOf(const NodeBox& nodes) const;
  AxisNode at(int axis, int node) const;
  /// The stored distance to a structure out of reach.
  std::int16_t farUnits() const;

  std::array<AxisCut, 3> cuts;
  std::array<int, 3> voxels, size;
  Vec3 spacing_mm;
  Transform nodeFromPatient;
  Vec3 smoothing_mm;  ///< SD of the smoothing of outlines
  double freedom_mm;  ///< by which smoothing may move an outline: half a voxel
  /// Nodes that one depends on: by the smoothing of distances, and by their reach.
  std::array<int, 3> smoothed, reach;
};

}  // namespace insonate
