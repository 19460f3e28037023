#include "scene/TissueTiles.h"

#include "scene/VoxelBlend.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <string>

namespace insonate {
namespace {

/// Maximum size of boxes that are made for one scene; work and memory of a larger one would delay cancellation.
constexpr int kMaxNodes = 160;

/// Equal parts of a box, none longer than kMaxNodes.
std::vector<NodeBox> partsOf(const NodeBox& box) {
  std::array<int, 3> count;
  for (int a = 0; a < 3; ++a) count[a] = (box.size[a] + kMaxNodes - 1) / kMaxNodes;
  std::vector<NodeBox> parts;
  const NodeBox all{{}, count};
  for (std::size_t p = 0; p < all.count(); ++p) {
    const int at[] = {static_cast<int>(p % count[0]), static_cast<int>(p / count[0] % count[1]),
                      static_cast<int>(p / count[0] / count[1])};
    NodeBox part;
    for (int a = 0; a < 3; ++a) {
      part.low[a] = box.low[a] + box.size[a] * at[a] / count[a];
      part.size[a] = box.low[a] + box.size[a] * (at[a] + 1) / count[a] - part.low[a];
    }
    parts.push_back(part);
  }
  return parts;
}

/// A part of a tile, with the structures within reach of it.
TissueTiles::TilePtr cutOut(const TissueTile& tile, const NodeBox& box, std::int16_t far) {
  auto part = std::make_shared<TissueTile>();
  part->box = box;
  const auto forRows = [&](const auto& row) {
    for (int k = box.low[2]; k < box.high(2); ++k)
      for (int j = box.low[1]; j < box.high(1); ++j) row(tile.box.offset(box.low[0], j, k));
  };
  for (std::size_t s = 0; s < tile.labels.size(); ++s) {
    const std::int16_t* distance = tile.distance.data() + s * tile.box.count();
    bool near = false;
    forRows([&](std::size_t n) {
      near = near || std::any_of(distance + n, distance + n + box.size[0], [far](std::int16_t d) { return d != far; });
    });
    if (!near) continue;
    part->labels.push_back(tile.labels[s]);
    part->distance.reserve(part->labels.size() * box.count());
    forRows(
        [&](std::size_t n) { part->distance.insert(part->distance.end(), distance + n, distance + n + box.size[0]); });
  }
  part->ctDeviation.reserve(box.count());
  forRows([&](std::size_t n) {
    const auto row = tile.ctDeviation.begin() + std::ptrdiff_t(n);
    part->ctDeviation.insert(part->ctDeviation.end(), row, row + box.size[0]);
  });
  part->distance.shrink_to_fit();
  return part;
}

}  // namespace

TissueTiles::TissueTiles(const CtVolume& ct, const LabelMap& labels, const CaseFacts& facts, const NodeLattice& lattice)
    : ct_(ct), labels_(labels), facts_(facts), lattice_(lattice), tiles_(cubesOf(lattice_.whole(), kEdge).size) {}

std::vector<std::uint64_t> TissueTiles::jsonKeys(const NodeBox& box) const {
  const NodeBox touched = cubesOf(box, kEdge);
  std::vector<std::uint64_t> keys;
  for (int k = touched.low[2]; k < touched.high(2); ++k)
    for (int j = touched.low[1]; j < touched.high(1); ++j)
      for (int i = touched.low[0]; i < touched.high(0); ++i)
        keys.push_back((std::uint64_t(k) * tiles_[1] + j) * tiles_[0] + i);
  return keys;
}

NodeBox TissueTiles::boxOf(std::uint64_t key) const {
  const auto i = static_cast<int>(key % tiles_[0]), j = static_cast<int>(key / tiles_[0] % tiles_[1]),
             k = static_cast<int>(key / tiles_[0] / tiles_[1]);
  return overlap({{i * kEdge, j * kEdge, k * kEdge}, {kEdge, kEdge, kEdge}}, lattice_.whole());
}

TissueTiles::TilePtr TissueTiles::make(const NodeBox& box, const Stopped& stopped) const {
  const NodeBox read = grown(grown(box, lattice_.smoothed, lattice_.whole()), lattice_.reach, lattice_.whole());
  NodeLabels nodes{read, std::vector<std::uint8_t>(read.count())};
  const auto slice = [](const NodeBox& of, int k) {
    return NodeBox{{of.low[0], of.low[1], k}, {of.size[0], of.size[1], 1}};
  };
  auto tile = std::make_shared<TissueTile>();
  tile->box = box;
  tile->ctDeviation.resize(box.count());
  tbb::parallel_for(read.low[2], read.high(2), [&](int k) {
    const NodeBox whole = slice(read, k);
    labelsOfNodes(labels_, lattice_, whole, {&nodes.label[read.offset(read.low[0], read.low[1], k)], whole.count()});
    if (k < box.low[2] || k >= box.high(2)) return;
    const NodeBox wanted = slice(box, k);
    deviationsOfNodes(ct_, labels_, facts_.mean_HU, lattice_, wanted,
                      {&tile->ctDeviation[box.offset(box.low[0], box.low[1], k)], wanted.count()});
  });
  DistanceTransform transform(lattice_, nodes, box, stopped);
  auto found = transform.distances(facts_.labelsNear(lattice_.voxelsOf(read)));
  tile->labels = std::move(found.labels);
  tile->distance = std::move(found.distance);
  return tile;
}

/// Empty if any is missing.
std::vector<TissueTiles::TilePtr> TissueTiles::kept(const NodeBox& box) {
  const std::vector<std::uint64_t> keys = jsonKeys(box);
  std::vector<TilePtr> tiles;
  const std::lock_guard lock(mutex_);
  ++use_;
  for (const std::uint64_t key : keys) {
    const auto found = kept_.find(key);
    if (found == kept_.end()) return {};
    found->second.lastUse = use_;
    for (const TilePtr& cube : found->second.cubes)
      if (overlap(cube->box, box).count() > 0) tiles.push_back(cube);
  }
  return tiles;
}

/// Removes first the tiles whose last request is oldest.
void TissueTiles::keep(std::uint64_t key, const TissueTile& tile) {
  constexpr int kCube = 16;
  Kept kept{{}, 0, 0};
  const NodeBox cubes = cubesOf(tile.box, kCube);
  for (int k = cubes.low[2]; k < cubes.high(2); ++k)
    for (int j = cubes.low[1]; j < cubes.high(1); ++j)
      for (int i = cubes.low[0]; i < cubes.high(0); ++i) {
        const NodeBox cube{{i * kCube, j * kCube, k * kCube}, {kCube, kCube, kCube}};
        kept.cubes.push_back(cutOut(tile, overlap(cube, tile.box), lattice_.farUnits()));
        kept.bytes += kept.cubes.back()->bytes();
      }
  const std::lock_guard lock(mutex_);
  kept.lastUse = use_ + 1;
  const auto [at, added] = kept_.try_emplace(key, std::move(kept));
  if (added) bytes_ += at->second.bytes;
  while (bytes_ > kMostBytes && kept_.size() > 1) {
    const auto oldest = std::ranges::min_element(kept_, {}, [](const auto& one) { return one.second.lastUse; });
    bytes_ -= oldest->second.bytes;
    kept_.erase(oldest);
  }
}

Result<std::vector<TissueTiles::TilePtr>> TissueTiles::covering(const NodeBox& box, const Progress& progress) {
  constexpr std::string_view kDoing = "Measuring distances to structures";
  std::vector<TilePtr> tiles = kept(box);
  if (!tiles.empty()) return tiles;
  const std::vector<NodeBox> parts = partsOf(box);
  for (const NodeBox& part : parts) {
    if (!report(progress, kDoing, static_cast<double>(tiles.size()) / static_cast<double>(parts.size())))
      return fail(std::string(kCancelled));
    tiles.push_back(make(part, {}));
  }
  if (!report(progress, kDoing, 1)) return fail(std::string(kCancelled));
  return tiles;
}

bool TissueTiles::precompute(const NodeBox& box, const Stopped& stopped) {
  std::optional<std::uint64_t> nearest;
  double least = 0;
  std::size_t wantedBytes = 0, greatest = 0;
  {
    const std::lock_guard lock(mutex_);
    ++use_;
    for (const std::uint64_t key : jsonKeys(box)) {
      if (const auto found = kept_.find(key); found != kept_.end()) {
        found->second.lastUse = use_;
        wantedBytes += found->second.bytes;
        greatest = std::max(greatest, found->second.bytes);
        continue;
      }
      const NodeBox tile = boxOf(key);
      double distance2 = 0;
      for (int a = 0; a < 3; ++a) {
        const double off = (tile.low[a] + 0.5 * tile.size[a] - box.low[a] - 0.5 * box.size[a]) * lattice_.spacing_mm[a];
        distance2 += off * off;
      }
      if (!nearest || distance2 < least) nearest = key, least = distance2;
    }
  }
  if (!nearest || wantedBytes + greatest > kMostBytes) return false;
  const TilePtr tile = make(boxOf(*nearest), stopped);
  if (stopped && stopped()) return false;
  keep(*nearest, *tile);
  return true;
}

}  // namespace insonate
