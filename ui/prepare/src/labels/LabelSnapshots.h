#pragma once

#include <insonate/image/VoxelBox.h>

#include <array>
#include <atomic>
#include <memory>
#include <vector>

namespace insonate::prepare {

/// Makes constant copies of a label map under edit, for readers on other threads. The memory of released copies is
/// reused and only later changes are copied, so that a snapshot normally costs no more than the changes. For the thread
/// that writes to the map.
class LabelSnapshots {
 public:
  /// Number of snapshots that are normally in use at once: one by computations on earlier labels, one by the next
  /// reader. Taking another snapshot takes some hundredths of a second for a large map. The memory of that snapshot is
  /// freed when it is released.
  static constexpr int kUsual = 2;
  using Copies = std::array<LabelMap, kUsual>;

  /// The map must outlive this object; snapshots may exist longer. `copies` must be equal to the map.
  LabelSnapshots(const LabelMap& labels, Copies copies);

  /// Must be called after each change of voxels in `box`.
  void changed(const VoxelBox& box);
  /// Returns a snapshot of the present map; the same object as before if nothing has changed.
  std::shared_ptr<const LabelMap> take();
  /// Returns a snapshot if it takes only a few milliseconds; null if other readers hold all copies, or if much has
  /// changed since the last snapshot.
  std::shared_ptr<const LabelMap> takeIfCheap();

 private:
  struct Copy {
    LabelMap map;
    std::vector<VoxelBox> stale;  ///< for each slice, the block that has changed since the copy was made
    std::atomic<bool> held{false};
  };

  /// Returns the newest copy that no reader holds, which needs the fewest updates; null if there is none.
  std::shared_ptr<Copy> newestFree() const;

  const LabelMap& labels_;
  std::vector<std::shared_ptr<Copy>> copies_;  ///< the latest copy is last
  std::weak_ptr<const LabelMap> latest_;
};

}  // namespace insonate::prepare
