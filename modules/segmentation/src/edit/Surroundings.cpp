#include "edit/Surroundings.h"

#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>

namespace insonate::segmentation {
namespace {

/// The limits of the automatic labels: air below -300 HU, fat up to halfway between fat and muscle.
constexpr int kAirBelow_HU = -300, kFatBelow_HU = -30;

/// Labels that tissue with such a CT value may take from its neighbors. Vessels, nerves, bone and skin have borders of
/// their own, and do not grow into a part that was removed beside them.
constexpr std::array<std::uint8_t, 2> kAir{kBackground, kAirway};
constexpr std::array<std::uint8_t, 7> kSoft{kMuscle, kSoftTissue, kSternocleidomastoid, kThyroid, kOesophagus,
                                            kGland,  kLymphNode};

using Counts = std::array<std::size_t, 256>;

template <std::size_t N>
std::uint8_t mostFrequent(const std::array<std::uint8_t, N>& among, const Counts& counts) {
  const auto most = std::ranges::max_element(among, {}, [&](std::uint8_t label) { return counts[label]; });
  return counts[*most] > 0 ? *most : std::uint8_t(kSoftTissue);
}

/// Finds the removed parts of a proposal one after the other.
class Parts {
 public:
  Parts(const CtVolume& ct, const LabelMap& labels, const LabelSet& removed, std::uint8_t marker, Proposal& proposal)
      : ct_(ct), labels_(labels), removed_(removed), marker_(marker), proposal_(proposal) {
    done_.assign(proposal.labels.voxels.size(), false);
  }

  void replaceAll() {
    const VoxelBox& box = proposal_.box;
    for (int k = box.first[2]; k < box.end[2]; ++k)
      for (int j = box.first[1]; j < box.end[1]; ++j)
        for (int i = box.first[0]; i < box.end[0]; ++i)
          if (const Voxel at{i, j, k}; isRemoved(at) && !done_[offset(at)]) replacePart(at);
  }

 private:
  using Voxel = std::array<int, 3>;

  std::size_t offset(const Voxel& at) const {
    const VoxelBox& box = proposal_.box;
    return proposal_.labels.geometry.offset(at[0] - box.first[0], at[1] - box.first[1], at[2] - box.first[2]);
  }
  bool isRemoved(const Voxel& at) const {
    if (!proposal_.box.contains(at[0], at[1], at[2])) return false;
    return (done_[offset(at)] || proposal_.labels.voxels[offset(at)] == marker_) &&
           removed_.test(labels_.at(at[0], at[1], at[2]));
  }

  void replacePart(const Voxel& first) {
    part_.assign(1, first);
    done_[offset(first)] = true;
    Counts counts{};
    for (std::size_t n = 0; n < part_.size(); ++n)
      for (int axis = 0; axis < 3; ++axis)
        for (const int step : {-1, 1}) {
          Voxel next = part_[n];
          next[std::size_t(axis)] += step;
          if (!labels_.geometry.contains(next[0], next[1], next[2])) continue;
          if (!isRemoved(next))
            ++counts[labels_.at(next[0], next[1], next[2])];
          else if (!done_[offset(next)])
            done_[offset(next)] = true, part_.push_back(next);
        }
    const std::uint8_t air = mostFrequent(kAir, counts), soft = mostFrequent(kSoft, counts);
    for (const Voxel& at : part_) {
      const int hu = ct_.at(at[0], at[1], at[2]);
      proposal_.labels.voxels[offset(at)] = hu < kAirBelow_HU ? air : hu < kFatBelow_HU ? std::uint8_t(kFat) : soft;
    }
  }

  const CtVolume& ct_;
  const LabelMap& labels_;
  const LabelSet& removed_;
  std::uint8_t marker_;
  Proposal& proposal_;
  std::vector<bool> done_;
  std::vector<Voxel> part_;
};

}  // namespace

void takeSurroundings(const CtVolume& ct, const LabelMap& labels, const LabelSet& removed, std::uint8_t marker,
                      Proposal& proposal) {
  if (!proposal.box.empty()) Parts(ct, labels, removed, marker, proposal).replaceAll();
}

}  // namespace insonate::segmentation
