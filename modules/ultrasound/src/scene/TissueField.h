#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/core/Transform.h>
#include <insonate/ultrasound/AcousticScene.h>

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace insonate {

class TissueTiles;

/// Allocator that leaves new elements uninitialized: the caller fills all of them, and setting them to zero on one
/// thread first would take time.
template <class T>
struct UninitialisedAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = UninitialisedAllocator<U>;
  };
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    if constexpr (sizeof...(Arguments) == 0)
      ::new (static_cast<void*>(place)) U;
    else
      ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }
};

template <class T>
using UninitialisedVector = std::vector<T, UninitialisedAllocator<T>>;

/// Smooth signed distances to every structure on a fine, nearly isotropic lattice, whose nodes divide the voxels of the
/// label map into equal parts, so that boundaries show no steps. There is one channel for each structure present. The
/// channels of a node are adjacent in memory, so that one trilinear look-up fetches all of them.
struct TissueField {
  static constexpr int kStride = 16;          ///< maximum number of channels of a node
  static constexpr double kUnitsPerMm = 256;  ///< stored distances are whole multiples of 1 / kUnitsPerMm
  static constexpr double kReach_mm = 6;      ///< maximum absolute value of the stored distances
  /// Extra CT deviations after the last, so that each can be loaded as a 32-bit word.
  static constexpr int kPadding = 1;

  std::array<int, 3> size{};                  ///< number of nodes along each axis
  Transform nodeFromPatient;                  ///< maps a patient point to a continuous node index
  int channels = 0;                           ///< number of channels: structures present in the field
  std::array<std::uint8_t, kStride> label{};  ///< label of each channel
  int backgroundChannel = -1;                 ///< channel of label 0 (background); -1 if the scene has none
  /// Distances to each channel's structure, negative inside, in 1/256 mm. Aligned, so that no node crosses a cache
  /// line.
  struct alignas(2 * kStride) Distances {
    std::int16_t to[kStride];
  };
  UninitialisedVector<Distances> distance;        ///< signed distances, [node]
  UninitialisedVector<std::int16_t> ctDeviation;  ///< [node], plus padding: CT minus the structure's mean, HU

  std::size_t offset(int i, int j, int k) const { return (std::size_t(k) * size[1] + j) * size[0] + i; }
};

/// Makes the field of a region. Fails if the region lies outside the volume, or if cancelled.
Result<TissueField> makeTissueField(TissueTiles& tiles, const Region& region, const Progress& progress);

}  // namespace insonate
