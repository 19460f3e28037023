#include "PartComposer.h"

#include "../files/LabelGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace insonate {
namespace {

/// Smallest box around the voxels that are not zero.
template <class T>
VoxelBox filledBox(const Volume<T>& map) {
  const auto& size = map.geometry.size;
  VoxelBox box{{size[0], size[1], size[2]}, {}};
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j) {
      const T* const row = map.voxels.data() + map.geometry.offset(0, j, k);
      const T* const end = row + size[0];
      const T* const first = std::find_if(row, end, [](T value) { return value != 0; });
      if (first == end) continue;
      int last = size[0] - 1;
      while (row[last] == 0) --last;
      const std::array<int, 3> low{int(first - row), j, k}, high{last + 1, j + 1, k + 1};
      for (int a = 0; a < 3; ++a) {
        box.first[a] = std::min(box.first[a], low[a]);
        box.end[a] = std::max(box.end[a], high[a]);
      }
    }
  return box;
}

/// Box of the voxels of `grid` on which a box of another grid, one voxel larger on all sides, can have an effect.
VoxelBox reachedBox(const VoxelBox& box, const Transform& gridFromMap, const VolumeGeometry& grid) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Vec3 low{kInfinity, kInfinity, kInfinity}, high{-kInfinity, -kInfinity, -kInfinity};
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 at;
    for (int a = 0; a < 3; ++a) at[a] = (corner >> a & 1) != 0 ? box.end[a] : box.first[a] - 1.0;
    const Vec3 p = gridFromMap * at;
    for (int a = 0; a < 3; ++a) low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
  }
  VoxelBox reached;
  for (int a = 0; a < 3; ++a) {
    reached.first[a] = int(std::clamp(std::floor(low[a]), 0.0, double(grid.size[a])));
    reached.end[a] = int(std::clamp(std::ceil(high[a]) + 1, 0.0, double(grid.size[a])));
  }
  return reached;
}

/// Value of the nearest voxel.
template <class T>
T nearestValue(const Volume<T>& map, Vec3 index) {
  const auto [i, j, k] = nearestVoxel(index);
  return map.geometry.contains(i, j, k) ? map.at(i, j, k) : T{0};
}

/// The value with the greatest weight in a linear interpolation between the eight neighbors. For one structure, this is
/// the region in which its interpolated mask is above one half.
template <class T>
T strongestValue(const Volume<T>& map, Vec3 index) {
  std::array<int, 3> low;
  Vec3 share;
  for (int a = 0; a < 3; ++a) {
    low[a] = int(std::floor(index[a]));
    share[a] = index[a] - low[a];
  }
  std::array<T, 8> values{};
  bool allSame = true;
  for (int corner = 0; corner < 8; ++corner) {
    const int i = low[0] + (corner & 1), j = low[1] + (corner >> 1 & 1), k = low[2] + (corner >> 2);
    values[corner] = map.geometry.contains(i, j, k) ? map.at(i, j, k) : T{0};
    allSame = allSame && values[corner] == values[0];
  }
  if (allSame) return values[0];
  std::array<double, 8> weights{};
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1;
    for (int a = 0; a < 3; ++a) weight *= (corner >> a & 1) != 0 ? share[a] : 1 - share[a];
    const auto first = std::ranges::find(values, values[corner]);
    weights[first - values.begin()] += weight;
  }
  return values[std::ranges::max_element(weights) - weights.begin()];
}

std::array<Vec3, 3> voxelSteps(const VolumeGeometry& g) {
  const auto& axis = g.direction.column;
  return {axis[0] * g.spacing_mm.x, axis[1] * g.spacing_mm.y, axis[2] * g.spacing_mm.z};
}

}  // namespace

Result<std::uint16_t> PartComposer::addPart(int priority, std::uint8_t label) {
  if (all_.size() >= std::numeric_limits<std::uint16_t>::max()) return fail("There are more than 65535 structures.");
  all_.push_back({priority, label});
  return static_cast<std::uint16_t>(all_.size());
}

void PartComposer::add(std::size_t voxel, std::uint16_t number, Vec3 index) {
  Part& part = all_[number - 1u];
  ++part.voxels;
  part.indexSum = part.indexSum + index;
  std::uint16_t& here = parts_.voxels[voxel];
  if (here == number) return;
  if (here != 0) {
    const Part& there = all_[here - 1u];
    overlaps_ += there.label != part.label && there.priority != kBelowAll && part.priority != kBelowAll;
  }
  if (here == 0 || part.priority > all_[here - 1u].priority) here = number;
}

template <class T, class Number>
Result<void> PartComposer::placeMap(const Volume<T>& map, const Number& numberOf, Sampling sampling,
                                    const Progress& progress) {
  const VolumeGeometry& grid = parts_.geometry;
  const VoxelBox filled = filledBox(map);
  if (filled.empty()) return {};
  const bool onVoxels =
      sameGrid(map.geometry, grid) || fallsOnVoxels(grid, map.geometry.origin_mm, voxelSteps(map.geometry));
  if (!sameGrid(map.geometry, grid)) ++(onVoxels ? moved_ : sampling == Sampling::kSmooth ? smoothed_ : nearest_);
  Transform mapFromGrid = map.geometry.indexFromPatient() * grid.patientFromIndex();
  const Transform gridFromMap = grid.indexFromPatient() * map.geometry.patientFromIndex();
  mapFromGrid.offset = mapFromGrid.offset - Vec3{kOffTheBorder, kOffTheBorder, kOffTheBorder};
  const VoxelBox box = reachedBox(filled, gridFromMap, grid);
  for (int k = box.first[2]; k < box.end[2]; ++k) {
    if (!report(progress, "Placing labels", double(k) / grid.size[2])) return fail(std::string(kCancelled));
    for (int j = box.first[1]; j < box.end[1]; ++j)
      for (int i = box.first[0]; i < box.end[0]; ++i) {
        const Vec3 index{double(i), double(j), double(k)}, there = mapFromGrid * index;
        const T value =
            onVoxels || sampling == Sampling::kNearest ? nearestValue(map, there) : strongestValue(map, there);
        if (value != 0) add(grid.offset(i, j, k), numberOf(value), index);
      }
  }
  for (int k = filled.first[2]; k < filled.end[2]; ++k)
    for (int j = filled.first[1]; j < filled.end[1]; ++j)
      for (int i = filled.first[0]; i < filled.end[0]; ++i) {
        if (map.at(i, j, k) == 0) continue;
        const auto [x, y, z] = nearestVoxel(gridFromMap * Vec3{double(i), double(j), double(k)});
        lost_ += !grid.contains(x, y, z);
      }
  return {};
}

Result<void> PartComposer::place(const Volume<std::uint8_t>& mask, std::uint16_t number, const Progress& progress) {
  return placeMap(
      mask, [number](std::uint8_t) { return number; }, Sampling::kSmooth, progress);
}

Result<void> PartComposer::place(const Volume<std::uint16_t>& map, Sampling sampling, const Progress& progress) {
  return placeMap(
      map, [](std::uint16_t number) { return number; }, sampling, progress);
}

void PartComposer::place(const VoxelBox& block, const std::vector<std::uint8_t>& inside, std::uint16_t number) {
  const std::uint8_t* value = inside.data();
  for (int k = block.first[2]; k < block.end[2]; ++k)
    for (int j = block.first[1]; j < block.end[1]; ++j)
      for (int i = block.first[0]; i < block.end[0]; ++i)
        if (*value++ != 0) add(parts_.geometry.offset(i, j, k), number, Vec3{double(i), double(j), double(k)});
}

bool PartComposer::isOutside() const {
  return lost_ > 0 && std::ranges::all_of(all_, [](const Part& one) { return one.voxels == 0; });
}

Vec3 PartComposer::centerOf_mm(std::uint16_t number) const {
  const Part& one = part(number);
  return parts_.geometry.patientFromIndex() * (one.indexSum / double(std::max<std::size_t>(one.voxels, 1)));
}

std::vector<std::string> PartComposer::notes() const {
  std::vector<std::string> notes;
  if (moved_ > 0) noteOtherGrid(true, 0, notes);
  if (nearest_ > 0) noteOtherGrid(false, 0, notes);
  if (smoothed_ > 0)
    notes.push_back(
        "The labels lie on another grid than the CT; they were resampled by linear interpolation, so that borders may "
        "have moved by half a voxel.");
  if (lost_ > 0) notes.push_back(std::to_string(lost_) + " labeled voxels lie outside the CT and were left out.");
  if (overlaps_ > 0)
    notes.push_back(std::to_string(overlaps_) +
                    " voxels belong to several structures; vessels and other thin structures have precedence.");
  return notes;
}

}  // namespace insonate
