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

/// Signed distances and CT deviations of one cube of lattice nodes. They depend only on the case.
struct TissueTile {
  NodeBox box;
  std::vector<std::uint8_t> labels;    ///< labels of the structures whose distance is below the limit
  std::vector<std::int16_t> distance;  ///< signed distances in 1/256 mm (TissueField::kUnitsPerMm), [structure][node]
  std::vector<std::int16_t> ctDeviation;  ///< [node] CT minus the structure's mean, HU

  std::size_t bytes() const { return sizeof(TissueTile) + labels.size() + 2 * (distance.size() + ctDeviation.size()); }
};

/// Tiles (cubes of nodes) of one patient on one lattice. The lattice is divided into tiles by a fixed grid, independent
/// of regions; tiles are computed ahead of need, and cached while there is room. Any number of threads may use one
/// object.
class TissueTiles {
 public:
  static constexpr int kEdge = 128;  ///< edge of a tile in nodes
  static constexpr std::size_t kMostBytes = std::size_t(384) << 20;
  using TilePtr = std::shared_ptr<const TissueTile>;

  /// `ct`, `labels` and `facts` must outlive this object.
  TissueTiles(const CtVolume& ct, const LabelMap& labels, const CaseFacts& facts, const NodeLattice& lattice);

  const NodeLattice& lattice() const { return lattice_; }
  /// Returns tiles that cover a box of nodes: cached tiles or, if some are missing, tiles made for this box alone,
  /// which is faster. Fails only if cancelled.
  Result<std::vector<TilePtr>> covering(const NodeBox& box, const Progress& progress);
  /// Makes and caches the one missing tile of a box that is nearest to the box's center. Returns false if none is
  /// missing, if there is no room for another tile, or if stopped.
  bool precompute(const NodeBox& box, const Stopped& stopped);

 private:
  /// A cached tile, divided into small cubes, since in each cube only few structures are within reach.
  struct Kept {
    std::vector<TilePtr> cubes;
    std::size_t bytes;
    std::uint64_t lastUse;
  };
  std::vector<std::uint64_t> jsonKeys(const NodeBox& box) const;
  NodeBox boxOf(std::uint64_t key) const;
  std::vector<TilePtr> kept(const NodeBox& box);
  TilePtr make(const NodeBox& box, const Stopped& stopped) const;
  void keep(std::uint64_t key, const TissueTile& tile);

  const CtVolume& ct_;
  const LabelMap& labels_;
  const CaseFacts& facts_;
  const NodeLattice lattice_;
  const std::array<int, 3> tiles_;

  std::mutex mutex_;  ///< guards the following members
  std::unordered_map<std::uint64_t, Kept> kept_;
  std::size_t bytes_ = 0;
  std::uint64_t use_ = 0;
};

}  // namespace insonate
