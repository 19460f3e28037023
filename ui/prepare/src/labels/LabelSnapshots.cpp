#include "LabelSnapshots.h"

#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <utility>

namespace insonate::prepare {
namespace {

void copyBlock(const LabelMap& from, const VoxelBox& box, LabelMap& to) {
  for (int k = box.first[2]; k < box.end[2]; ++k)
    for (int j = box.first[1]; j < box.end[1]; ++j) {
      const std::uint8_t* const row = &from.at(box.first[0], j, k);
      std::copy_n(row, box.length(0), &to.at(box.first[0], j, k));
    }
}

/// Number of voxels whose copy takes about a millisecond.
constexpr std::size_t kFew = std::size_t{4} << 20;

std::size_t voxelsIn(const std::vector<VoxelBox>& boxes) {
  std::size_t voxels = 0;
  for (const VoxelBox& box : boxes)
    if (!box.empty()) voxels += std::size_t(box.length(0)) * box.length(1) * box.length(2);
  return voxels;
}

template <class Copy>
bool isFree(const std::shared_ptr<Copy>& copy) {
  return !copy->held.load(std::memory_order_acquire);
}

/// The part of a box in one slice.
VoxelBox inSlice(VoxelBox box, int slice) {
  box.first[2] = slice, box.end[2] = slice + 1;
  return box;
}

}  // namespace

LabelSnapshots::LabelSnapshots(const LabelMap& labels, Copies copies) : labels_(labels) {
  for (LabelMap& copy : copies) {
    copies_.push_back(std::make_shared<Copy>());
    copies_.back()->map = std::move(copy);
    copies_.back()->stale.resize(std::size_t(labels.geometry.size[2]));
  }
}

void LabelSnapshots::changed(const VoxelBox& box) {
  for (const auto& copy : copies_)
    for (int k = box.first[2]; k < box.end[2]; ++k) {
      VoxelBox& stale = copy->stale[std::size_t(k)];
      stale = united(stale, inSlice(box, k));
    }
  latest_.reset();
}

std::shared_ptr<LabelSnapshots::Copy> LabelSnapshots::newestFree() const {
  const auto newest = std::find_if(copies_.rbegin(), copies_.rend(), isFree<Copy>);
  return newest == copies_.rend() ? nullptr : *newest;
}

std::shared_ptr<const LabelMap> LabelSnapshots::takeIfCheap() {
  if (auto latest = latest_.lock()) return latest;
  const auto copy = newestFree();
  return copy && voxelsIn(copy->stale) <= kFew ? take() : nullptr;
}

std::shared_ptr<const LabelMap> LabelSnapshots::take() {
  if (auto latest = latest_.lock()) return latest;
  std::shared_ptr<Copy> copy = newestFree();
  std::erase(copies_, copy);
  const auto oldest = std::ranges::find_if(copies_, isFree<Copy>);
  if (copies_.size() >= kUsual && oldest != copies_.end()) copies_.erase(oldest);
  if (!copy) {
    copy = std::make_shared<Copy>();
    copy->map.geometry = labels_.geometry;
    copy->map.voxels.resize(labels_.voxels.size());
    for (int k = 0; k < labels_.geometry.size[2]; ++k) copy->stale.push_back(inSlice(boxOf(labels_.geometry), k));
  }
  const auto update = [&](VoxelBox& stale) {
    if (!stale.empty()) copyBlock(labels_, std::exchange(stale, {}), copy->map);
  };
  // A small copy takes less time than waiting for threads that may not run at once.
  if (voxelsIn(copy->stale) <= kFew)
    std::ranges::for_each(copy->stale, update);
  else
    tbb::parallel_for_each(copy->stale, update);
  copy->held.store(true, std::memory_order_relaxed);
  copies_.push_back(copy);
  const LabelMap* const map = &copy->map;
  std::shared_ptr<const LabelMap> taken(
      map, [copy](const LabelMap*) { copy->held.store(false, std::memory_order_release); });
  latest_ = taken;
  return taken;
}

}  // namespace insonate::prepare
