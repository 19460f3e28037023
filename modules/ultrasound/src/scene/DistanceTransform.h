#pragma once

#include "scene/NodeLattice.h"
#include "scene/OutlineSmoothing.h"

#include <cstdint>
#include <vector>

namespace insonate {

/// The label of each node of a box.
struct NodeLabels {
  NodeBox box;
  std::vector<std::uint8_t> label;
};

/// Signed distances to the structures of a block of nodes, negative inside, with smoothed outlines. Structures are
/// computed in parallel in the calling thread's arena.
class DistanceTransform {
 public:
  struct Result {
    std::vector<std::uint8_t> labels;    ///< labels of the structures within reach
    std::vector<std::int16_t> distance;  ///< [structure][node of the block], in units of TissueField
  };

  /// `nodes` contains all labels within the block's smoothing and reach margins, except beyond the lattice. The result
  /// depends on nothing else.
  DistanceTransform(const NodeLattice& lattice, const NodeLabels& nodes, const NodeBox& block, Stopped stopped);

  /// Distances to those candidates (one bit per label) that are within reach. The result is not usable if stopped.
  Result distances(std::uint32_t candidates);

 private:
  struct Structure {
    std::uint8_t label;
    NodeBox near;                 ///< nodes that may be within reach of the structure; nodes beyond are out of reach
    std::vector<float> outside2;  ///< [near] squared distance to the structure; 0 on its own nodes
    std::vector<std::int16_t> distance;  ///< [near] signed, smoothed
  };
  /// Buffers of one thread.
  struct Scratch {
    std::vector<float> rows, planes, run, signed_mm, part_mm, add;
    std::vector<std::uint8_t> rowNear, planeNear;  ///< rows that contain nodes within reach
    std::vector<const float*> window;
    OutlineSmoothing smoothing;
  };
  NodeBox boundsOf(std::uint8_t label) const;
  void measure(Structure& structure, Scratch& scratch) const;
  void alongX(const Structure& structure, const NodeBox& bounds, Scratch& scratch) const;
  void alongY(const NodeBox& near, const NodeBox& bounds, Scratch& scratch) const;
  void alongZ(const NodeBox& bounds, Scratch& scratch, Structure& structure) const;
  void markDecisive();
  NodeBox decisivePart(const Structure& structure) const;
  void round(Structure& structure, Scratch& scratch) const;
  std::vector<std::int16_t> leastDistances() const;
  void keepThinStructures();
  Result blockOf() const;

  bool stopped() const { return stopped_ && stopped_(); }

  const NodeLattice& lattice_;
  const NodeLabels& nodes_;
  /// Nodes for which distances are requested, for which they are computed, and for which labels are read.
  const NodeBox block_, smoothed_, read_;
  const NodeBox seen_;            ///< the block and its neighbors
  const float half_mm_;           ///< distance between a node and the boundary behind it
  const std::vector<float> far_;  ///< a row of values that mean out of reach
  const Stopped stopped_;
  std::vector<Structure> structures_;
  std::vector<float> inside2_;    ///< [smoothed_] squared distance to the nearest structure other than the node's own
  std::vector<float> decisive2_;  ///< [seen_] squared distance within which a structure is one of the two nearest
};

}  // namespace insonate
