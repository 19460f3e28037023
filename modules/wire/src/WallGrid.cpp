#include "WallGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace insonate::wire {
namespace {

constexpr double kCell_mm = 4, kMargin_mm = 12;
constexpr int kBlock = 4;  // cells of a block, which a first pass sorts
/// Half of a cell's diagonal; the distance of a tube that widens changes a little faster than the position.
constexpr double kHalf_mm = kCell_mm * 0.8661 * 1.1;

}  // namespace

WallGrid::WallGrid(std::vector<TubePiece> pieces) : pieces_(std::move(pieces)) {
  if (pieces_.empty()) return;
  Vec3 high_mm = low_mm = pieces_.front().from_mm;
  for (const TubePiece& piece : pieces_)
    for (const Vec3 end : {piece.from_mm, piece.from_mm + piece.along * piece.length_mm})
      for (int a = 0; a < 3; ++a) {
        const double reach_mm = piece.radius_mm + std::max(piece.slope, 0.0) * piece.length_mm + kMargin_mm;
        low_mm[a] = std::min(low_mm[a], end[a] - reach_mm), high_mm[a] = std::max(high_mm[a], end[a] + reach_mm);
      }
  int blocks[3];
  for (int a = 0; a < 3; ++a) {
    blocks[a] = static_cast<int>(std::ceil((high_mm[a] - low_mm[a]) / (kCell_mm * kBlock)));
    size_[a] = blocks[a] * kBlock;
  }
  std::vector<int> all(pieces_.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<std::vector<int>> coarse;
  for (int z = 0; z < blocks[2]; ++z)
    for (int y = 0; y < blocks[1]; ++y)
      for (int x = 0; x < blocks[0]; ++x) {
        const Vec3 middle = low_mm + Vec3{x + 0.5, y + 0.5, z + 0.5} * (kCell_mm * kBlock);
        coarse.push_back(candidatesFor(all, middle, kHalf_mm * kBlock));
      }
  for (int z = 0; z < size_[2]; ++z)
    for (int y = 0; y < size_[1]; ++y)
      for (int x = 0; x < size_[0]; ++x) {
        first_.push_back(static_cast<std::uint32_t>(list_.size()));
        const int block = (z / kBlock * blocks[1] + y / kBlock) * blocks[0] + x / kBlock;
        const Vec3 middle = low_mm + Vec3{x + 0.5, y + 0.5, z + 0.5} * kCell_mm;
        const auto candidates = candidatesFor(coarse[block], middle, kHalf_mm);
        list_.insert(list_.end(), candidates.begin(), candidates.end());
      }
  first_.push_back(static_cast<std::uint32_t>(list_.size()));
}

std::vector<int> WallGrid::candidatesFor(std::span<const int> among, Vec3 middle, double half_mm) const {
  double least_mm = std::numeric_limits<double>::infinity();
  for (const int i : among) least_mm = std::min(least_mm, pieces_[i].nearest(middle).distance_mm);
  std::vector<int> candidates;
  for (const int i : among)
    if (pieces_[i].nearest(middle).distance_mm <= least_mm + 2 * half_mm) candidates.push_back(i);
  return candidates;
}

int WallGrid::find(Vec3 p, TubePiece::Nearest& nearest) const noexcept {
  int found = -1;
  nearest.distance_mm = std::numeric_limits<double>::infinity();
  const auto consider = [&](int i) {
    const auto here = pieces_[i].nearest(p);
    if (here.distance_mm < nearest.distance_mm) nearest = here, found = i;
  };
  int cell[3];
  bool inside = !pieces_.empty();
  for (int a = 0; a < 3 && inside; ++a) {
    const double at = std::floor((p[a] - low_mm[a]) / kCell_mm);
    inside = at >= 0 && at < size_[a];
    cell[a] = inside ? static_cast<int>(at) : 0;
  }
  if (inside) {
    const std::size_t at = (std::size_t(cell[2]) * size_[1] + cell[1]) * size_[0] + cell[0];
    for (std::uint32_t k = first_[at]; k < first_[at + 1]; ++k) consider(list_[k]);
  } else {
    for (int i = 0; i < static_cast<int>(pieces_.size()); ++i) consider(i);
  }
  return found;
}

}  // namespace insonate::wire
