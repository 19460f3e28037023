#pragma once

#include "scene/CaseFacts.h"
#include "scene/DistanceTransform.h"
#include "scene/NodeLattice.h"

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

namespace insonate {

/// Distances and CT deviations of one cube of nodes. It depends on the case alone.
struct TissueTile {
  NodeBox box;
  std::vector<std::uint8_t> labels;       ///< of the structures within reach
  std::vector<std::int16_t> distance;     ///< [structure][node], in units of TissueField
  std::vector<std::int16_t> ctDeviation;  ///< [node], HU above the structure's mean

  std::size_t bytes() const { return sizeof(TissueTile) + labels.size() + 2 * (distance.size() + ctDeviation.size()); }
};

/// Tiles of one patient on one lattice. They lie on a grid of their own, are computed ahead of need, and kept while
/// there is room. Any number of threads may ask.
class TissueTiles {
 public:
  static constexpr int kEdge = 128;  ///< nodes
  static constexpr std::size_t kMostBytes = std::size_t(384) << 20;
  using TilePtr = std::shared_ptr<const TissueTile>;

  /// Volumes and facts must outlive this.
  TissueTiles(const CtVolume& ct, const LabelMap& labels, const CaseFacts& facts, double detail_mm);

  const NodeLattice& lattice() const { return lattice_; }
  /// Tiles that cover a box of nodes: those that are kept, or else such as are made for this box alone, since they are
  /// there sooner. Fails only when cancelled.
  Result<std::vector<TilePtr>> covering(const NodeBox& box, const Progress& progress);
  /// Makes the one tile that a box misses and that is nearest to the box's center, and keeps it. False where none is
  /// missing, where there is no room for one more, and when stopped.
  bool makeAhead(const NodeBox& box, const Stopped& stopped);

 private:
  /// A tile in small cubes: in each of them, only few structures are within reach.
  struct Kept {
    std::vector<TilePtr> cubes;
    std::size_t bytes;
    std::uint64_t lastUse;
  };
  std::vector<std::uint64_t> keysOf(const NodeBox& box) const;
  NodeBox boxOf(std::uint64_t key) const;
  std::vector<TilePtr> kept(const NodeBox& box);
  TilePtr make(const NodeBox& box, const Stopped& stopped) const;
  void keep(std::uint64_t key, const TissueTile& tile);

  const CtVolume& ct_;
  const LabelMap& labels_;
  const CaseFacts& facts_;
  const NodeLattice lattice_;
  const std::array<int, 3> tiles_;

  std::mutex mutex_;  ///< of the following
  std::unordered_map<std::uint64_t, Kept> kept_;
  std::size_t bytes_ = 0;
  std::uint64_t use_ = 0;
};

}  // namespace insonate
