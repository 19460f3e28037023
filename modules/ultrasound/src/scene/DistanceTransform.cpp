#include "scene/DistanceTransform.h"

#include "scene/RowFilters.h"
#include "scene/TissueField.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace insonate {
namespace {

constexpr auto kReach = static_cast<float>(TissueField::kReach_mm);
constexpr float kReach2 = kReach * kReach;

std::int16_t unitsOf(float mm) {
  const float units = mm * static_cast<float>(TissueField::kUnitsPerMm);
  return static_cast<std::int16_t>(units < 0 ? units - 0.5F : units + 0.5F);
}

/// Calls `row` with its first node and its width.
template <class Row>
void forRows(const NodeBox& box, const Row& row) {
  if (box.count() == 0) return;
  for (int k = box.low[2]; k < box.high(2); ++k)
    for (int j = box.low[1]; j < box.high(1); ++j) row(box.low[0], j, k, box.size[0]);
}

bool contains(const NodeBox& box, int i, int j, int k) {
  return i >= box.low[0] && i < box.high(0) && j >= box.low[1] && j < box.high(1) && k >= box.low[2] && k < box.high(2);
}

}  // namespace

/// Box of the nodes with a label, within the range that is read; empty if there are none.
NodeBox DistanceTransform::boundsOf(std::uint8_t label) const {
  std::array<int, 3> low{read_.high(0), read_.high(1), read_.high(2)}, high{};
  const int width = read_.size[0];
  for (int k = read_.low[2]; k < read_.high(2); ++k)
    for (int j = read_.low[1]; j < read_.high(1); ++j) {
      const std::uint8_t* row = nodes_.label.data() + nodes_.box.offset(read_.low[0], j, k);
      const auto* first = static_cast<const std::uint8_t*>(std::memchr(row, label, width));
      if (!first) continue;
      const auto* last = static_cast<const std::uint8_t*>(memrchr(row, label, width));
      low = {std::min(low[0], read_.low[0] + int(first - row)), std::min(low[1], j), std::min(low[2], k)};
      high = {std::max(high[0], read_.low[0] + int(last - row) + 1), std::max(high[1], j + 1), k + 1};
    }
  NodeBox bounds{low, {}};
  for (int a = 0; a < 3; ++a) bounds.size[a] = std::max(0, high[a] - low[a]);
  return bounds;
}

/// Squared distance along x to the nearest node of the structure, in the rows that may contain one.
void DistanceTransform::alongX(const Structure& structure, const NodeBox& bounds, Scratch& scratch) const {
  const auto h = static_cast<float>(lattice_.spacing_mm.x);
  const NodeBox& near = structure.near;
  const int begin = std::min(near.low[0], bounds.low[0]), width = std::max(near.high(0), bounds.high(0)) - begin;
  std::vector<float>& distance = scratch.run;
  distance.resize(width);
  std::size_t row = 0;
  for (int k = bounds.low[2]; k < bounds.high(2); ++k)
    for (int j = bounds.low[1]; j < bounds.high(1); ++j, ++row) {
      const std::uint8_t* labels = nodes_.label.data() + nodes_.box.offset(begin, j, k);
      scratch.rowNear[row] = std::memchr(labels, structure.label, width) != nullptr;
      if (!scratch.rowNear[row]) continue;
      float run = kReach;
      for (int i = 0; i < width; ++i) distance[i] = run = labels[i] == structure.label ? 0 : std::min(run + h, kReach);
      run = kReach;
      for (int i = width - 1; i >= 0; --i) {
        run = labels[i] == structure.label ? 0 : std::min(run + h, kReach);
        distance[i] = std::min(distance[i], run);
      }
      const float* in = distance.data() + (near.low[0] - begin);
      float* out = scratch.rows.data() + row * near.size[0];
      for (int i = 0; i < near.size[0]; ++i) out[i] = in[i] * in[i];
    }
}

/// Lower envelope of parabolas, by brute force within the reach: the window is a few nodes wide, and vectors run along
/// x. Rows out of reach are skipped.
void DistanceTransform::alongY(const NodeBox& near, const NodeBox& bounds, Scratch& scratch) const {
  const double h = lattice_.spacing_mm.y;
  const int window = static_cast<int>(kReach / h), nx = near.size[0];
  std::size_t out = 0;
  for (int k = bounds.low[2]; k < bounds.high(2); ++k)
    for (int here = near.low[1]; here < near.high(1); ++here, ++out) {
      scratch.window.assign(1, far_.data()), scratch.add.assign(1, 0);
      const int last = std::min(here + window, bounds.high(1) - 1);
      for (int there = std::max(bounds.low[1], here - window); there <= last; ++there) {
        const std::size_t row = std::size_t(k - bounds.low[2]) * bounds.size[1] + (there - bounds.low[1]);
        if (!scratch.rowNear[row]) continue;
        scratch.window.push_back(scratch.rows.data() + row * nx);
        scratch.add.push_back(static_cast<float>((there - here) * h * (there - here) * h));
      }
      scratch.planeNear[out] = scratch.window.size() > 1;
      if (scratch.planeNear[out])
        leastOfRows(scratch.window, scratch.add, {scratch.planes.data() + out * nx, std::size_t(nx)});
    }
}

void DistanceTransform::alongZ(const NodeBox& bounds, Scratch& scratch, Structure& structure) const {
  const double h = lattice_.spacing_mm.z;
  const NodeBox& near = structure.near;
  const int window = static_cast<int>(kReach / h), nx = near.size[0];
  float* out = structure.outside2.data();
  for (int here = near.low[2]; here < near.high(2); ++here)
    for (int j = 0; j < near.size[1]; ++j, out += nx) {
      scratch.window.assign(1, far_.data()), scratch.add.assign(1, 0);
      const int last = std::min(here + window, bounds.high(2) - 1);
      for (int there = std::max(bounds.low[2], here - window); there <= last; ++there) {
        const std::size_t row = std::size_t(there - bounds.low[2]) * near.size[1] + j;
        if (!scratch.planeNear[row]) continue;
        scratch.window.push_back(scratch.planes.data() + row * nx);
        scratch.add.push_back(static_cast<float>((there - here) * h * (there - here) * h));
      }
      leastOfRows(scratch.window, scratch.add, {out, std::size_t(nx)});
    }
}

/// If the structure is out of reach, `near` stays empty.
void DistanceTransform::measure(Structure& structure, Scratch& scratch) const {
  const NodeBox bounds = boundsOf(structure.label);
  if (bounds.count() == 0 || stopped()) return;
  structure.near = overlap(grown(bounds, lattice_.reach, lattice_.whole()), smoothed_);
  const NodeBox& near = structure.near;
  if (near.count() == 0) return;
  scratch.rowNear.resize(std::size_t(bounds.size[1]) * bounds.size[2]);
  scratch.rows.resize(scratch.rowNear.size() * near.size[0]);
  scratch.planeNear.resize(std::size_t(near.size[1]) * bounds.size[2]);
  scratch.planes.resize(scratch.planeNear.size() * near.size[0]);
  alongX(structure, bounds, scratch);
  alongY(near, bounds, scratch);
  if (stopped()) return;
  structure.outside2.resize(near.count());
  alongZ(bounds, scratch, structure);
  if (std::ranges::none_of(structure.outside2, [](float d2) { return d2 < kReach2; })) structure.near = {};
}

/// Engines use the two nearest structures, and their boundary only if it is near. No other distances need smoothing.
void DistanceTransform::markDecisive() {
  constexpr float kNear_mm = 5;
  const auto slack_mm = static_cast<float>(2 * lattice_.freedom_mm + 0.5);
  decisive2_.resize(seen_.count());
  std::size_t n = 0;
  for (int k = seen_.low[2]; k < seen_.high(2); ++k)
    for (int j = seen_.low[1]; j < seen_.high(1); ++j) {
      const float* inside2 = inside2_.data() + smoothed_.offset(seen_.low[0], j, k);
      for (int i = 0; i < seen_.size[0]; ++i, ++n) {
        const float limit_mm = std::sqrt(inside2[i]) + slack_mm;
        decisive2_[n] = inside2[i] < kNear_mm * kNear_mm ? limit_mm * limit_mm : -1;
      }
    }
}

/// The box of all nodes at which a structure may be one of the two nearest; empty if there are none.
NodeBox DistanceTransform::decisivePart(const Structure& structure) const {
  std::array<int, 3> low{seen_.high(0), seen_.high(1), seen_.high(2)}, high{-1, -1, -1};
  forRows(overlap(structure.near, seen_), [&](int i0, int j, int k, int width) {
    const float* outside2 = structure.outside2.data() + structure.near.offset(i0, j, k);
    const float* limit2 = decisive2_.data() + seen_.offset(i0, j, k);
    int first = -1, last = -1;
    for (int i = 0; i < width; ++i)
      if (outside2[i] <= limit2[i] && outside2[i] < kReach2) last = i, first = first < 0 ? i : first;
    if (first < 0) return;
    low = {std::min(low[0], i0 + first), std::min(low[1], j), std::min(low[2], k)};
    high = {std::max(high[0], i0 + last), std::max(high[1], j), std::max(high[2], k)};
  });
  NodeBox part{low, {}};
  for (int a = 0; a < 3; ++a) part.size[a] = std::max(0, high[a] + 1 - low[a]);
  return part;
}

void DistanceTransform::round(Structure& structure, Scratch& scratch) const {
  const NodeBox& near = structure.near;
  std::vector<float>&all_mm = scratch.signed_mm, &part_mm = scratch.part_mm;
  all_mm.resize(near.count());
  forRows(near, [&](int i, int j, int k, int width) {
    const std::size_t n = near.offset(i, j, k), w = width;
    signedDistance({structure.outside2.data() + n, w}, {inside2_.data() + smoothed_.offset(i, j, k), w}, half_mm_,
                   {all_mm.data() + n, w});
  });
  structure.distance.resize(all_mm.size());
  std::ranges::transform(all_mm, structure.distance.begin(), unitsOf);
  const NodeBox part = decisivePart(structure);
  if (structures_.size() < 2 || part.count() == 0) return;
  const NodeBox around = overlap(grown(part, lattice_.smoothed, lattice_.whole()), smoothed_);
  part_mm.assign(around.count(), kReach - half_mm_);
  forRows(overlap(around, near), [&](int i, int j, int k, int width) {
    std::copy_n(all_mm.data() + near.offset(i, j, k), width, part_mm.data() + around.offset(i, j, k));
  });
  scratch.smoothing.roundStairs(lattice_, around, stopped_, part_mm);
  forRows(part, [&](int i, int j, int k, int width) {
    const float* row = part_mm.data() + around.offset(i, j, k);
    std::transform(row, row + width, structure.distance.data() + near.offset(i, j, k), unitsOf);
  });
}

/// Distances to the nearest structure, in units of TissueField, [smoothed_].
std::vector<std::int16_t> DistanceTransform::leastDistances() const {
  std::vector<std::int16_t> least(smoothed_.count(), lattice_.farUnits());
  for (const Structure& structure : structures_)
    forRows(structure.near, [&](int i0, int j, int k, int width) {
      const std::int16_t* distance = structure.distance.data() + structure.near.offset(i0, j, k);
      std::int16_t* row = least.data() + smoothed_.offset(i0, j, k);
      for (int i = 0; i < width; ++i) row[i] = std::min(row[i], distance[i]);
    });
  return least;
}

/// Smoothing would remove a structure hardly thicker than a voxel. If none of it is left around one of its nodes, the
/// outline of the label map is kept, so that a vessel of one voxel stays visible.
void DistanceTransform::keepThinStructures() {
  std::array<const Structure*, 256> of{};
  for (const Structure& structure : structures_) of[structure.label] = &structure;
  const auto labelAt = [&](int i, int j, int k) { return nodes_.label[nodes_.box.offset(i, j, k)]; };
  // Smoothing may leave a thin sheet outside of itself and of its neighbors: then the nearest structure is used. A node
  // with a label is near.
  const std::vector<std::int16_t> least = leastDistances();
  const auto nearest = [&](std::uint8_t label, int i, int j, int k) {
    return of[label]->distance[of[label]->near.offset(i, j, k)] <= least[smoothed_.offset(i, j, k)];
  };
  const auto survives = [&](int i, int j, int k, std::uint8_t label) {
    for (int z = std::max(k - 1, smoothed_.low[2]); z <= std::min(k + 1, smoothed_.high(2) - 1); ++z)
      for (int y = std::max(j - 1, smoothed_.low[1]); y <= std::min(j + 1, smoothed_.high(1) - 1); ++y)
        for (int x = std::max(i - 1, smoothed_.low[0]); x <= std::min(i + 1, smoothed_.high(0) - 1); ++x)
          if (labelAt(x, y, z) == label && nearest(label, x, y, z)) return true;
    return false;
  };
  std::vector<std::array<int, 3>> lost;  // all are found before any is changed
  forRows(block_, [&](int i0, int j, int k, int width) {
    for (int i = i0; i < i0 + width; ++i) {
      const std::uint8_t label = labelAt(i, j, k);
      if (!nearest(label, i, j, k) && !survives(i, j, k, label)) lost.push_back({i, j, k});
    }
  });
  for (const auto& [i, j, k] : lost) {
    const std::int16_t depth = unitsOf(std::sqrt(inside2_[smoothed_.offset(i, j, k)]) - half_mm_);
    for (Structure& structure : structures_) {
      if (!contains(structure.near, i, j, k)) continue;
      std::int16_t& d = structure.distance[structure.near.offset(i, j, k)];
      d = structure.label == labelAt(i, j, k) ? static_cast<std::int16_t>(-depth) : std::max(d, depth);
    }
  }
}

DistanceTransform::DistanceTransform(const NodeLattice& lattice, const NodeLabels& nodes, const NodeBox& block,
                                     Stopped stopped)
    : lattice_(lattice),
      nodes_(nodes),
      block_(block),
      smoothed_(grown(block, lattice.smoothed, lattice.whole())),
      read_(grown(smoothed_, lattice.reach, lattice.whole())),
      seen_(overlap(grown(block, {2, 2, 2}, lattice.whole()), smoothed_)),
      // Distances are between node centers; the boundary is half a node closer.
      half_mm_(static_cast<float>((lattice.spacing_mm.x + lattice.spacing_mm.y + lattice.spacing_mm.z) / 6)),
      far_(smoothed_.size[0], kReach2),
      stopped_(std::move(stopped)) {}

DistanceTransform::Result DistanceTransform::distances(std::uint32_t candidates) {
  structures_.clear();
  for (int label = 0; label < 32; ++label)
    if (candidates >> label & 1) structures_.push_back({static_cast<std::uint8_t>(label), {}, {}, {}});
  tbb::enumerable_thread_specific<Scratch> scratch;
  const auto each = [&](const auto& work) {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, structures_.size(), 1),
        [&](const auto& range) {
          for (std::size_t s = range.begin(); s < range.end(); ++s) work(structures_[s], scratch.local());
        },
        tbb::simple_partitioner());
  };
  each([this](Structure& structure, Scratch& its) { measure(structure, its); });
  if (stopped()) return {};
  std::erase_if(structures_, [](const Structure& structure) { return structure.near.count() == 0; });
  inside2_.assign(smoothed_.count(), kReach2);
  for (const Structure& structure : structures_)
    forRows(structure.near, [&](int i, int j, int k, int width) {
      leastPositive({structure.outside2.data() + structure.near.offset(i, j, k), std::size_t(width)},
                    {inside2_.data() + smoothed_.offset(i, j, k), std::size_t(width)});
    });
  markDecisive();
  each([this](Structure& structure, Scratch& its) {
    round(structure, its);
    structure.outside2 = {};
  });
  if (stopped()) return {};
  if (structures_.size() > 1) keepThinStructures();
  return blockOf();
}

/// Structures out of reach of the block's own nodes are skipped.
DistanceTransform::Result DistanceTransform::blockOf() const {
  const std::int16_t far = lattice_.farUnits();
  Result result;
  for (const Structure& structure : structures_) {
    const std::size_t before = result.distance.size();
    result.distance.resize(before + block_.count(), far);
    bool near = false;
    forRows(overlap(structure.near, block_), [&](int i, int j, int k, int width) {
      const std::int16_t* row = structure.distance.data() + structure.near.offset(i, j, k);
      near = near || std::any_of(row, row + width, [far](std::int16_t d) { return d != far; });
      std::copy_n(row, width, result.distance.data() + before + block_.offset(i, j, k));
    });
    if (near)
      result.labels.push_back(structure.label);
    else
      result.distance.resize(before);
  }
  return result;
}

}  // namespace insonate
