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

}  // namespace

/// Squared distance along x to the nearest node of the structure.
void DistanceTransform::alongX(std::uint8_t label, Scratch& scratch) const {
  const auto h = static_cast<float>(lattice_.spacing_mm.x);
  const int before = smoothed_.low[0] - read_.low[0], width = read_.size[0];
  std::vector<float>& distance = scratch.run;
  distance.resize(width);
  for (int k = read_.low[2]; k < read_.high(2); ++k)
    for (int j = read_.low[1]; j < read_.high(1); ++j) {
      const std::size_t row = std::size_t(k - read_.low[2]) * read_.size[1] + (j - read_.low[1]);
      const std::uint8_t* labels = nodes_.label.data() + nodes_.box.offset(read_.low[0], j, k);
      scratch.rowNear[row] = std::memchr(labels, label, width) != nullptr;
      if (!scratch.rowNear[row]) continue;
      float run = kReach;
      for (int i = 0; i < width; ++i) distance[i] = run = labels[i] == label ? 0 : std::min(run + h, kReach);
      run = kReach;
      for (int i = width - 1; i >= 0; --i) {
        run = labels[i] == label ? 0 : std::min(run + h, kReach);
        distance[i] = std::min(distance[i], run);
      }
      float* out = scratch.rows.data() + row * smoothed_.size[0];
      for (int i = 0; i < smoothed_.size[0]; ++i) out[i] = distance[before + i] * distance[before + i];
    }
}

/// Lower envelope of parabolas, by brute force within the reach: the window is a few nodes wide, and vectors run along
/// x. Rows out of reach are left out.
void DistanceTransform::alongY(Scratch& scratch) const {
  const double h = lattice_.spacing_mm.y;
  const int window = static_cast<int>(kReach / h), nx = smoothed_.size[0];
  for (int k = 0; k < read_.size[2]; ++k)
    for (int j = 0; j < smoothed_.size[1]; ++j) {
      const int here = j + smoothed_.low[1] - read_.low[1];
      scratch.window.assign(1, far_.data()), scratch.add.assign(1, 0);
      for (int there = std::max(0, here - window); there <= std::min(here + window, read_.size[1] - 1); ++there) {
        const std::size_t row = std::size_t(k) * read_.size[1] + there;
        if (!scratch.rowNear[row]) continue;
        scratch.window.push_back(scratch.rows.data() + row * nx);
        scratch.add.push_back(static_cast<float>((there - here) * h * (there - here) * h));
      }
      const std::size_t row = std::size_t(k) * smoothed_.size[1] + j;
      scratch.planeNear[row] = scratch.window.size() > 1;
      if (scratch.planeNear[row])
        leastOfRows(scratch.window, scratch.add, {scratch.planes.data() + row * nx, std::size_t(nx)});
    }
}

void DistanceTransform::alongZ(Scratch& scratch, std::vector<float>& outside2) const {
  const double h = lattice_.spacing_mm.z;
  const int window = static_cast<int>(kReach / h), nx = smoothed_.size[0], ny = smoothed_.size[1];
  for (int k = 0; k < smoothed_.size[2]; ++k) {
    const int here = k + smoothed_.low[2] - read_.low[2];
    for (int j = 0; j < ny; ++j) {
      scratch.window.assign(1, far_.data()), scratch.add.assign(1, 0);
      for (int there = std::max(0, here - window); there <= std::min(here + window, read_.size[2] - 1); ++there) {
        const std::size_t row = std::size_t(there) * ny + j;
        if (!scratch.planeNear[row]) continue;
        scratch.window.push_back(scratch.planes.data() + row * nx);
        scratch.add.push_back(static_cast<float>((there - here) * h * (there - here) * h));
      }
      leastOfRows(scratch.window, scratch.add, {outside2.data() + (std::size_t(k) * ny + j) * nx, std::size_t(nx)});
    }
  }
}

/// False where the structure is out of reach.
bool DistanceTransform::measure(std::uint8_t label, Scratch& scratch, std::vector<float>& outside2) const {
  scratch.rowNear.resize(std::size_t(read_.size[1]) * read_.size[2]);
  scratch.rows.resize(scratch.rowNear.size() * smoothed_.size[0]);
  scratch.planeNear.resize(std::size_t(smoothed_.size[1]) * read_.size[2]);
  scratch.planes.resize(scratch.planeNear.size() * smoothed_.size[0]);
  alongX(label, scratch);
  if (std::ranges::find(scratch.rowNear, 1) == scratch.rowNear.end()) return false;
  if (stopped()) return false;
  alongY(scratch);
  if (stopped()) return false;
  outside2.resize(smoothed_.count());
  alongZ(scratch, outside2);
  return std::ranges::any_of(outside2, [](float d2) { return d2 < kReach2; });
}

/// Engines ask for the two nearest structures, and for their boundary only where it is near. Whatever else there is
/// need not be rounded.
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

/// The box of all nodes where a structure may be one of the two nearest; empty where it never is.
NodeBox DistanceTransform::decisivePart(const Structure& structure) const {
  std::array<int, 3> low{seen_.high(0), seen_.high(1), seen_.high(2)}, high{-1, -1, -1};
  for (int k = seen_.low[2]; k < seen_.high(2); ++k)
    for (int j = seen_.low[1]; j < seen_.high(1); ++j) {
      const float* outside2 = structure.outside2.data() + smoothed_.offset(seen_.low[0], j, k);
      const float* limit2 = decisive2_.data() + seen_.offset(seen_.low[0], j, k);
      int first = -1, last = -1;
      for (int i = 0; i < seen_.size[0]; ++i)
        if (outside2[i] <= limit2[i] && outside2[i] < kReach2) last = i, first = first < 0 ? i : first;
      if (first < 0) continue;
      low = {std::min(low[0], seen_.low[0] + first), std::min(low[1], j), std::min(low[2], k)};
      high = {std::max(high[0], seen_.low[0] + last), std::max(high[1], j), std::max(high[2], k)};
    }
  NodeBox part{low, {}};
  for (int a = 0; a < 3; ++a) part.size[a] = std::max(0, high[a] + 1 - low[a]);
  return part;
}

void DistanceTransform::round(Structure& structure, Scratch& scratch) const {
  std::vector<float>&all_mm = scratch.signed_mm, &part_mm = scratch.part_mm;
  all_mm.resize(smoothed_.count());
  signedDistance(structure.outside2, inside2_, half_mm_, all_mm);
  structure.distance.resize(all_mm.size());
  std::ranges::transform(all_mm, structure.distance.begin(), unitsOf);
  const NodeBox part = decisivePart(structure);
  if (structures_.size() < 2 || part.count() == 0) return;
  const NodeBox around = overlap(grown(part, lattice_.smoothed, lattice_.whole()), smoothed_);
  part_mm.resize(around.count());
  const auto forRows = [this](const NodeBox& box, const auto& row) {
    for (int k = box.low[2]; k < box.high(2); ++k)
      for (int j = box.low[1]; j < box.high(1); ++j) row(j, k, smoothed_.offset(box.low[0], j, k));
  };
  forRows(around, [&](int j, int k, std::size_t n) {
    std::copy_n(all_mm.data() + n, around.size[0], part_mm.data() + around.offset(around.low[0], j, k));
  });
  scratch.smoothing.roundStairs(lattice_, around, stopped_, part_mm);
  forRows(part, [&](int j, int k, std::size_t n) {
    const float* row = part_mm.data() + around.offset(part.low[0], j, k);
    std::transform(row, row + part.size[0], structure.distance.data() + n, unitsOf);
  });
}

/// A structure hardly thicker than a voxel would be rounded away. Where nothing of it is left round one of its nodes,
/// the label map's outline stands: a vessel of one voxel is seen.
void DistanceTransform::keepThinStructures() {
  std::array<const Structure*, 256> of{};
  for (const Structure& structure : structures_) of[structure.label] = &structure;
  const auto labelAt = [&](int i, int j, int k) { return nodes_.label[nodes_.box.offset(i, j, k)]; };
  // Of a thin sheet that smoothing left outside of itself and of its neighbours alike, the nearest is seen.
  const auto nearest = [&](std::uint8_t label, std::size_t n) {
    const std::int16_t own = of[label]->distance[n];
    return std::ranges::none_of(structures_, [&](const Structure& other) { return other.distance[n] < own; });
  };
  const auto survives = [&](int i, int j, int k, std::uint8_t label) {
    for (int z = std::max(k - 1, smoothed_.low[2]); z <= std::min(k + 1, smoothed_.high(2) - 1); ++z)
      for (int y = std::max(j - 1, smoothed_.low[1]); y <= std::min(j + 1, smoothed_.high(1) - 1); ++y)
        for (int x = std::max(i - 1, smoothed_.low[0]); x <= std::min(i + 1, smoothed_.high(0) - 1); ++x)
          if (labelAt(x, y, z) == label && nearest(label, smoothed_.offset(x, y, z))) return true;
    return false;
  };
  std::vector<std::pair<std::size_t, std::uint8_t>> lost;  // all are found before any is changed
  for (int k = block_.low[2]; k < block_.high(2); ++k)
    for (int j = block_.low[1]; j < block_.high(1); ++j)
      for (int i = block_.low[0]; i < block_.high(0); ++i) {
        const std::uint8_t label = labelAt(i, j, k);
        const std::size_t n = smoothed_.offset(i, j, k);
        if (!nearest(label, n) && !survives(i, j, k, label)) lost.emplace_back(n, label);
      }
  for (const auto& [n, label] : lost) {
    const std::int16_t depth = unitsOf(std::sqrt(inside2_[n]) - half_mm_);
    for (Structure& structure : structures_) {
      std::int16_t& d = structure.distance[n];
      d = structure.label == label ? static_cast<std::int16_t>(-depth) : std::max(d, depth);
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
      // Distances run between node centres; the boundary lies half a node before.
      half_mm_(static_cast<float>((lattice.spacing_mm.x + lattice.spacing_mm.y + lattice.spacing_mm.z) / 6)),
      far_(smoothed_.size[0], kReach2),
      stopped_(std::move(stopped)) {}

DistanceTransform::Result DistanceTransform::distances(std::uint32_t candidates) {
  structures_.clear();
  for (int label = 0; label < 32; ++label)
    if (candidates >> label & 1) structures_.push_back({static_cast<std::uint8_t>(label), {}, {}});
  tbb::enumerable_thread_specific<Scratch> scratch;
  const auto each = [&](const auto& work) {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, structures_.size(), 1),
        [&](const auto& range) {
          for (std::size_t s = range.begin(); s < range.end(); ++s) work(structures_[s], scratch.local());
        },
        tbb::simple_partitioner());
  };
  each([this](Structure& structure, Scratch& its) {
    if (!measure(structure.label, its, structure.outside2)) structure.outside2.clear();
  });
  std::erase_if(structures_, [](const Structure& structure) { return structure.outside2.empty(); });
  inside2_.assign(smoothed_.count(), kReach2);
  for (const Structure& structure : structures_) leastPositive(structure.outside2, inside2_);
  if (stopped()) return {};
  markDecisive();
  each([this](Structure& structure, Scratch& its) {
    round(structure, its);
    structure.outside2 = {};
  });
  if (stopped()) return {};
  if (structures_.size() > 1) keepThinStructures();
  return blockOf();
}

/// Structures that do not come within reach of the block's own nodes are left out.
DistanceTransform::Result DistanceTransform::blockOf() const {
  const std::int16_t far = lattice_.farUnits();
  Result result;
  for (const Structure& structure : structures_) {
    const std::size_t before = result.distance.size();
    bool near = false;
    for (int k = block_.low[2]; k < block_.high(2); ++k)
      for (int j = block_.low[1]; j < block_.high(1); ++j) {
        const auto row = structure.distance.begin() + std::ptrdiff_t(smoothed_.offset(block_.low[0], j, k));
        near = near || std::any_of(row, row + block_.size[0], [far](std::int16_t d) { return d != far; });
        result.distance.insert(result.distance.end(), row, row + block_.size[0]);
      }
    if (near)
      result.labels.push_back(structure.label);
    else
      result.distance.resize(before);
  }
  return result;
}

}  // namespace insonate
