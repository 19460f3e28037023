#include "WallGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace insonate::wire {
namespace {

constexpr double kCell_mm = 4, kMargin_mm = 12;
constexpr int kBlock = 4;  // cells of a block, which a first pass sorts
/// Half of a cell's diagonal; the distance to a tube that widens or is not round changes faster than the position.
constexpr double kHalf_mm = kCell_mm * 0.8661 * 1.3;

Vec3 times(const Section& m, Vec3 x) {
  return {m[0] * x.x + m[3] * x.y + m[4] * x.z, m[3] * x.x + m[1] * x.y + m[5] * x.z,
          m[4] * x.x + m[5] * x.y + m[2] * x.z};
}

constexpr double kOnAxis_mm = 1e-9;

}  // namespace

Section TubePiece::sectionAt(double t_mm) const noexcept {
  Section here = section;
  for (std::size_t k = 0; k < here.size(); ++k) here[k] += change[k] * t_mm;
  return here;
}

/// For an ellipse, the first-order distance (f - 1) / |grad f| with f = sqrt(x M x) (Sampson 1982), which is exact for
/// a circle: (f^2 - f) / |M x|.
TubePiece::Nearest TubePiece::nearest(Vec3 p) const noexcept {
  const Vec3 from = p - from_mm;
  double t = dot(from, along);
  t = t < 0 ? 0 : t > length_mm ? length_mm : t;
  const Vec3 away = from - along * t;
  const double radius = radius_mm + slope * t, off_mm = norm(away);
  if (isRound || off_mm < kOnAxis_mm) return {off_mm - radius, t, away, off_mm / radius};
  const Vec3 mx = times(sectionAt(t), away);
  const double f = std::sqrt(dot(away, mx));
  return {(f * f - f) / norm(mx), t, away, f};
}

Vec3 TubePiece::outward(const Nearest& nearest) const noexcept {
  const Vec3& x = nearest.away;
  const double off_mm = norm(x);
  if (off_mm < kOnAxis_mm) return {};
  const bool isBeside = nearest.t_mm > 0 && nearest.t_mm < length_mm;
  if (isRound) return isBeside ? x / off_mm - along * slope : x / off_mm;
  const Section m = sectionAt(nearest.t_mm);
  const Vec3 mx = times(m, x), dmx = times(change, x);
  const double f = nearest.relative, g = norm(mx), excess = (f * f - f) / (g * g);
  const Vec3 byX = mx * ((2 * f - 1) / (f * g)) - times(m, mx) * (excess / g);
  if (!isBeside) return byX;
  const double byT = (2 * f - 1) * dot(x, dmx) / (2 * f * g) - excess * dot(mx, dmx) / g;
  return byX - along * (dot(byX, along) - byT);
}

double TubePiece::curvature_1pmm(const Nearest& nearest) const noexcept {
  const double off_mm = norm(nearest.away);
  if (off_mm < kOnAxis_mm) return 0;
  if (isRound) return 1 / off_mm;
  const Section m = sectionAt(nearest.t_mm);
  const Vec3 mx = times(m, nearest.away);
  const Vec3 around = cross(along, mx);
  const double size = norm(around);
  return size > 0 ? dot(around, times(m, around)) / (size * size * norm(mx)) : 0;
}

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
