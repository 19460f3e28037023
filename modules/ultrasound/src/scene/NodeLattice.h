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

/// Function that long computations call repeatedly, on their threads; returns true if the result is no longer needed.
/// May be empty.
using Stopped = std::function<bool()>;

/// A box of whole nodes or voxels.
struct NodeBox {
  std::array<int, 3> low{}, size{};

  int high(int axis) const { return low[axis] + size[axis]; }  ///< index after the last
  std::size_t count() const { return std::size_t(size[0]) * size[1] * size[2]; }
  std::size_t offset(int i, int j, int k) const {
    return (std::size_t(k - low[2]) * size[1] + (j - low[1])) * size[0] + (i - low[0]);
  }
};

/// Returns a box that is larger by `margin` on each side, limited to `limit`.
NodeBox grown(const NodeBox& box, const std::array<int, 3>& margin, const NodeBox& limit);
NodeBox overlap(const NodeBox& a, const NodeBox& b);
/// Returns the cubes that a box touches, with edges of `edge` nodes, counted from node 0; the result is in units of
/// cubes.
NodeBox cubesOf(const NodeBox& box, int edge);

/// Positions of the nodes at which a patient's distances are stored. Along each axis, a voxel is divided into equal
/// parts, or several voxels are merged. The lattice does not depend on a region.
struct NodeLattice {
  /// Division of one axis of the label map. At least one of the two numbers is 1.
  struct AxisCut {
    int parts = 1, merged = 1;
    double nodesPerVoxel() const { return double(parts) / merged; }
  };
  /// The two voxels between which a node is interpolated; both are the same at the volume's edge.
  struct AxisNode {
    int low, high;
    float weight;  ///< weight of the high voxel
  };

  /// Nodes are at most detail_mm apart.
  NodeLattice(const VolumeGeometry& grid, double detail_mm);

  NodeBox whole() const { return {{}, size}; }
  /// Returns the nodes around a region, with a small margin, limited to the lattice; empty if the region lies outside
  /// the volume.
  NodeBox boxOf(const Region& region) const;
  /// Returns the voxels that determine a box of nodes.
  NodeBox voxelsOf(const NodeBox& nodes) const;
  AxisNode at(int axis, int node) const;
  /// Stored distance to a structure that is out of reach.
  std::int16_t farUnits() const;

  std::array<AxisCut, 3> cuts;
  std::array<int, 3> voxels, size;
  Vec3 spacing_mm;
  Transform nodeFromPatient;
  Vec3 smoothing_mm;  ///< SD of the smoothing of outlines
  double freedom_mm;  ///< maximum movement of an outline by smoothing: half a voxel
  /// Number of nodes, to each side, that affect a node: through the smoothing of distances, and through their reach.
  std::array<int, 3> smoothed, reach;
};

}  // namespace insonate
