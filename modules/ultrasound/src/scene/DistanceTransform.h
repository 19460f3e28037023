#pragma once

#include "scene/NodeLattice.h"
#include "scene/OutlineSmoothing.h"

#include <cstdint>
#include <vector>

namespace insonate {

/// Labels of the lattice nodes of a box.
struct NodeLabels {
  NodeBox box;
  std::vector<std::uint8_t> label;
};

/// Computes signed distances from the nodes of a block to structures, negative inside, with smoothed outlines.
/// Structures are computed in parallel in the calling thread's arena.
class DistanceTransform {
 public:
  struct Result {
    std::vector<std::uint8_t> labels;  ///< labels of the structures whose distance is below the limit (within reach)
    /// Signed distances in 1/256 mm (TissueField::kUnitsPerMm), [structure][node of the block].
    std::vector<std::int16_t> distance;
  };

  /// `nodes` must contain the labels of all nodes up to the block's smoothing and reach margins; nodes beyond the
  /// lattice do not exist. The result depends on nothing else.
  DistanceTransform(const NodeLattice& lattice, const NodeLabels& nodes, const NodeBox& block, Stopped stopped);

  /// Returns the distances to those candidate labels (one bit per label) that are within reach. The result must not be
  /// used if the computation was stopped.
  Result distances(std::uint32_t candidates);

 private:
  struct Structure {
    std::uint8_t label;
    NodeBox near;                        ///< nodes that may be within reach of the structure; all others are not
    std::vector<float> outside2;         ///< [node of `near`] squared distance to the structure; 0 on its own nodes
    std::vector<std::int16_t> distance;  ///< [node of `near`] signed distance with smoothed outline
  };
  /// Buffers of one thread.
  struct Scratch {
    std::vector<float> rows, planes, run, signed_mm, part_mm, add;
    std::vector<std::uint8_t> rowNear, planeNear;  ///< flags of the rows and planes that contain nodes within reach
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
  /// Boxes of nodes: block_: distances are requested; smoothed_: distances are computed; read_: labels are read.
  const NodeBox block_, smoothed_, read_;
  const NodeBox seen_;            ///< nodes of the block and their neighbors
  const float half_mm_;           ///< distance from a node to the boundary between it and the next node
  const std::vector<float> far_;  ///< a row of the value that means "out of reach"
  const Stopped stopped_;
  std::vector<Structure> structures_;
  /// [node of smoothed_] squared distance to the nearest structure other than the node's own.
  std::vector<float> inside2_;
  /// [node of seen_] squared distance below which a structure is one of the two nearest at the node.
  std::vector<float> decisive2_;
};

}  // namespace insonate
