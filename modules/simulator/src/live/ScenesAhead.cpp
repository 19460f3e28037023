#include "live/ScenesAhead.h"

#include <insonate/core/ThreadPriority.h>

#include <tbb/task_arena.h>

#include <new>

namespace insonate::live {

ScenesAhead::ScenesAhead(std::shared_ptr<const SceneSource> source)
    : source_(std::move(source)), thread_([this] { work(); }) {}

ScenesAhead::~ScenesAhead() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void ScenesAhead::want(const Region& region_mm, double detail_mm) {
  {
    const std::lock_guard lock(mutex_);
    wanted_ = Wanted{region_mm, detail_mm};
    ++asked_;
  }
  changed_.notify_one();
}

void ScenesAhead::drop() {
  const std::lock_guard lock(mutex_);
  dropping_ = true;
  wanted_.reset();
}

void ScenesAhead::work() {
  lowerThreadPriority();
  tbb::task_arena arena(1);  // this thread alone, since workers would have the priority of images
  for (;;) {
    Wanted wanted;
    std::uint64_t asked = 0;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return stopping_ || wanted_; });
      if (stopping_) return;
      wanted = *wanted_;
      dropping_ = false;
      asked = asked_;
    }
    bool more = false;
    try {
      more = arena.execute([&] {
        return source_->precompute(wanted.region_mm, wanted.detail_mm, [this] { return stopping_ || dropping_; });
      });
    } catch (const std::bad_alloc&) {
      // On failure, scenes are computed when they are needed.
    }
    const std::lock_guard lock(mutex_);
    if (!more && asked == asked_) wanted_.reset();
  }
}

}  // namespace insonate::live
