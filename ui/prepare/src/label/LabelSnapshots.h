#pragma once

#include <insonate/image/VoxelBox.h>

#include <array>
#include <atomic>
#include <memory>
#include <vector>

namespace insonate::prepare {

/// Copies of a label map that is being written to, which never change while anybody holds them, for readers on other
/// threads. Memory of copies that were let go is used again: only what has changed since is copied, so that one costs
/// no more than the changes as a rule. For the thread that writes to the map.
class LabelSnapshots {
 public:
  /// As many are held at once as a rule: by what is computed still of earlier labels, and by who takes the next. A
  /// further one is made on the spot, which takes some hundredths of a second for a large map, and given back when it
  /// is let go.
  static constexpr int kUsual = 2;
  using Copies = std::array<LabelMap, kUsual>;

  /// The map lives longer, what was taken need not. `copies` are equal to it.
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
