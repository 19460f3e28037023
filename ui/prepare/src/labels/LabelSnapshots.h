#pragma once

#include <insonate/image/VoxelBox.h>

#include <array>
#include <atomic>
#include <memory>
#include <vector>

namespace insonate::prepare {

/// Constant copies of a label map that is being written to, for readers on other threads. Memory of released copies is
/// reused: only changes since are copied, so that a snapshot normally costs no more than the changes. For the thread
/// that writes to the map.
class LabelSnapshots {
 public:
  /// Number of snapshots normally held at once: one by computations on earlier labels, one by the next reader. A
  /// further one is made at once, which takes some hundredths of a second for a large map, and freed when it is
  /// released.
  static constexpr int kUsual = 2;
  using Copies = std::array<LabelMap, kUsual>;

  /// The map must outlive this, snapshots need not. `copies` are equal to it.
  LabelSnapshots(const LabelMap& labels, Copies copies);

  /// Say so after each change of voxels.
  void changed(const VoxelBox& box);
  /// The map as it is now; the same as before where nothing has changed.
  std::shared_ptr<const LabelMap> take();

 private:
  struct Copy {
    LabelMap map;
    VoxelBox stale;
    std::atomic<bool> held{false};
  };

  const LabelMap& labels_;
  std::vector<std::shared_ptr<Copy>> copies_;  ///< the latest last
  std::weak_ptr<const LabelMap> latest_;
};

}  // namespace insonate::prepare
