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

/// Leaves new elements as they are: who fills them all needs no zeros before, least of all on one thread.
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

/// Smooth signed distances to every structure on a fine, nearly isotropic lattice that cuts the voxels of the label map
/// into equal parts, so that boundaries show no voxel stairs and need no normals. One channel a structure present,
/// channels of a node side by side in memory, so that one trilinear look-up fetches all of them.
struct TissueField {
  static constexpr int kStride = 16;          ///< channels a node has room for
  static constexpr double kUnitsPerMm = 256;  ///< of the stored distances
  static constexpr double kReach_mm = 6;      ///< distances are cut off here
  static constexpr int kPadding = 1;          ///< CT deviations beyond the last, so that any can be fetched as a word

  std::array<int, 3> size{};                  ///< nodes
  Transform nodeFromPatient;                  ///< continuous node index of a patient point
  int channels = 0;                           ///< structures present
  std::array<std::uint8_t, kStride> label{};  ///< of each channel
  int backgroundChannel = -1;                 ///< channel of label 0, or -1
  /// Distances to each channel's structure, negative inside, 1/256 mm. Aligned, so that no node straddles two cache
  /// lines.
  struct alignas(2 * kStride) Distances {
    std::int16_t to[kStride];
  };
  UninitialisedVector<Distances> distance;        ///< [node]
  UninitialisedVector<std::int16_t> ctDeviation;  ///< [node] and padding, HU above the structure's mean

  std::size_t offset(int i, int j, int k) const { return (std::size_t(k) * size[1] + j) * size[0] + i; }
};

/// A region's part of the patient. Fails where the region misses the volume, and when cancelled.
Result<TissueField> makeTissueField(TissueTiles& tiles, const Region& region, const Progress& progress);

}  // namespace insonate
