#pragma once

#include <sys/resource.h>
#include <unistd.h>

namespace insonate {

/// Lowers the priority of this thread, and of threads that it starts later, below that of the window's thread and of
/// images that users wait for; high enough that it still ends promptly on request. Cannot be undone. Work that a
/// thread passes to TBB's workers has their priority: an arena of one thread keeps it here. setpriority(2): on Linux,
/// of a thread.
inline void lowerThreadPriority() {
  constexpr int kNice = 10;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);
}

}  // namespace insonate
