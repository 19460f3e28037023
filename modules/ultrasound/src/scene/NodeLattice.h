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

/// Function that a long computation calls repeatedly, on its own threads; returns true to stop the computation. May be
/// empty.
using Stopped = std::function<bool()>;

/// A box of whole nodes or voxels.
struct NodeBox {
  std::array<int, 3> low{}, size{};

  int high(int axis) const { return low[axis] + size[axis]; }  ///< index after the last node along the axis
  std::size_t count() const { return std::size_t(size[0]) * size[1] * size[2]; }
  std::size_t offset(int i, int j, int k) const {
    return (std::size_t(k - low[2]) * size[1] + (j - low[1])) * size[0] + (i - low[0]);
  }
};

/// Returns a box that is larger by `margin` on each side, limited to `limit`.
NodeBox grown(const NodeBox& box, const std::array<int, 3>& margin, const NodeBox& limit);
NodeBox overlap(const NodeBox& a, const NodeBox& b);
/// Divides the lattice into cubes with edges of `edge` nodes, counted from node 0, and returns the cubes that a box
/// touches, in units of cubes.
NodeBox cubesOf(const NodeBox& box, int edge);

/// Lattice of nodes at which signed distances in a patient are stored. Along each axis, a voxel is divided into equal
/// parts, or several voxels are merged. The lattice is the same for all regions of the patient.
struct NodeLattice {
  /// Division of one axis of the label map: a voxel is divided into `parts`, or `merged` voxels are merged. At least
  /// one of the two numbers is 1.
  struct AxisCut {
    int parts = 1, merged = 1;
    double nodesPerVoxel() const { return double(parts) / merged; }
  };
  /// The two voxels between which a node is interpolated; both are the same at the volume's edge.
  struct AxisNode {
    int low, high;
    float weight;  ///< interpolation weight of the voxel `high`
  };

  /// Makes the lattice of a label map's grid, with nodes at most detail_mm apart.
  NodeLattice(const VolumeGeometry& grid, double detail_mm);
  /// Makes a lattice for coarse scenes, with nodes about kCoarse_mm apart. Outlines are smoothed from a narrower
  /// margin, so that the outermost nodes of a box depend slightly on the box.
  static NodeLattice coarse(const VolumeGeometry& grid);
  static constexpr double kCoarse_mm = 1.4;

  NodeBox whole() const { return {{}, size}; }
  /// Returns the nodes around a region, with a small margin, limited to the lattice; empty if the region lies outside
  /// the volume.
  NodeBox boxOf(const Region& region) const;
  /// Returns the box of voxels from which the values of these nodes are computed.
  NodeBox voxelsOf(const NodeBox& nodes) const;
  AxisNode at(int axis, int node) const;
  /// Returns the value stored as the distance to a structure that is out of reach.
  std::int16_t farUnits() const;

  std::array<AxisCut, 3> cuts;
  std::array<int, 3> voxels, size;
  Vec3 spacing_mm;
  Transform nodeFromPatient;
  Vec3 smoothing_mm;  ///< SD of the Gaussian with which outlines are smoothed
  double freedom_mm;  ///< maximum distance by which smoothing may move an outline: half a voxel
  /// Number of neighboring nodes, to each side and by axis, that affect the value at a node: `smoothed`: through the
  /// smoothing of distances; `reach`: through the maximum distance.
  std::array<int, 3> smoothed, reach;

 private:
  NodeLattice(const VolumeGeometry& grid, const std::array<AxisCut, 3>& cuts);
  void setMargin(double smoothing_SD);
};

}  // namespace insonate
