#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>
#include <insonate/image/VoxelBox.h>

#include <cstdint>
#include <string>
#include <vector>

namespace insonate {

/// Rule by which voxels of another grid get their values.
enum class Sampling {
  kNearest,  ///< value of the nearest voxel
  kSmooth    ///< value with the greatest weight in a linear interpolation
};

/// Priority of the outline of the body, which lies below all structures by nature: notes do not count these overlaps.
constexpr int kBelowAll = -2;

/// Combines structures on the grid of a CT. Each structure has a number, counted from 1, and a priority: where
/// structures overlap, the higher priority wins, and among equal priorities the structure that was added first.
class PartComposer {
 public:
  struct Part {
    int priority = 0;
    std::uint8_t label = 0;
    std::size_t voxels = 0;  ///< voxels in the CT, also those that other structures cover
    Vec3 indexSum{};         ///< sum of the indices of these voxels
  };

  explicit PartComposer(const VolumeGeometry& grid) : parts_(grid) {}

  /// Adds a structure without voxels, and returns its number.
  Result<std::uint16_t> addPart(int priority, std::uint8_t label);

  /// Adds the voxels of `mask` that are not zero to the structure with this number.
  Result<void> place(const Volume<std::uint8_t>& mask, std::uint16_t number, const Progress& progress);
  /// Adds voxels whose values are numbers of structures.
  Result<void> place(const Volume<std::uint16_t>& map, Sampling sampling, const Progress& progress);
  /// Adds the voxels of a block of the CT's grid that are not zero; `inside` has the values of its voxels.
  void place(const VoxelBox& block, const std::vector<std::uint8_t>& inside, std::uint16_t number);

  const Part& part(std::uint16_t number) const { return all_[number - 1u]; }
  const Volume<std::uint16_t>& parts() const { return parts_; }
  std::size_t size() const { return all_.size(); }
  /// Tells whether voxels were added, but none of them lies in the CT.
  bool isOutside() const;
  Volume<std::uint16_t> takeParts() { return std::move(parts_); }
  /// Returns the center of a structure's voxels, patient LPS.
  Vec3 centerOf_mm(std::uint16_t number) const;

  /// Returns sentences about overlaps, other grids, and voxels outside the CT.
  std::vector<std::string> notes() const;

 private:
  template <class T, class Number>
  Result<void> placeMap(const Volume<T>& map, const Number& numberOf, Sampling sampling, const Progress& progress);
  void add(std::size_t voxel, std::uint16_t number, Vec3 index);

  Volume<std::uint16_t> parts_;
  std::vector<Part> all_;
  std::size_t overlaps_ = 0, lost_ = 0, smoothed_ = 0, nearest_ = 0, moved_ = 0;
};

}  // namespace insonate
