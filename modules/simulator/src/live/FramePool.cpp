#include "live/FramePool.h"

#include <cassert>

namespace insonate::live {

/// Allocates a shared_ptr's reference counts in its slot. They are freed last when a frame is released, which returns
/// the slot.
template <class T>
class CountMemory {
 public:
  using value_type = T;

  CountMemory(std::shared_ptr<FramePool> pool, FramePool::Slot* slot) : pool_(std::move(pool)), slot_(slot) {}
  template <class U>
  CountMemory(const CountMemory<U>& other) : pool_(other.pool_), slot_(other.slot_) {}

  T* allocate(std::size_t count) {
    static_assert(sizeof(T) <= sizeof(FramePool::Slot::counts) && alignof(T) <= alignof(std::max_align_t));
    assert(count == 1);
    return reinterpret_cast<T*>(slot_->counts) + (count - 1);
  }
  void deallocate(T*, std::size_t) { pool_->giveBack(std::unique_ptr<FramePool::Slot>(slot_)); }

  template <class U>
  bool operator==(const CountMemory<U>& other) const {
    return slot_ == other.slot_;
  }

 private:
  template <class U>
  friend class CountMemory;
  std::shared_ptr<FramePool> pool_;
  FramePool::Slot* slot_;
};

std::shared_ptr<LiveFrame> FramePool::acquire() {
  std::unique_ptr<Slot> slot;
  {
    const std::lock_guard lock(mutex_);
    free_.reserve(kSpare);
    if (!free_.empty()) {
      slot = std::move(free_.back());
      free_.pop_back();
    }
  }
  if (!slot) slot = std::make_unique<Slot>();
  Slot* const held = slot.release();  // giveBack() takes ownership again
  return std::shared_ptr<LiveFrame>(
      &held->frame, [](LiveFrame*) {}, CountMemory<LiveFrame>(shared_from_this(), held));
}

void FramePool::giveBack(std::unique_ptr<Slot> slot) {
  const std::lock_guard lock(mutex_);
  if (free_.size() < kSpare) free_.push_back(std::move(slot));
}

}  // namespace insonate::live
