#pragma once

#include <sys/resource.h>
#include <unistd.h>

namespace insonate {

/// Lowers the priority of this thread, and of threads that it starts later, below that of the GUI thread and of images
/// that users wait for; the thread still responds promptly to cancellation. The change cannot be undone. Work that the
/// thread passes to TBB's worker threads runs at their priority; to avoid that, run the work in a TBB arena of one
/// thread. On Linux, setpriority(2) acts on a single thread.
inline void lowerThreadPriority() {
  constexpr int kLower = 10;
  // The main thread's own priority counts, since the program may have been started at a lower one.
  const int nice = getpriority(PRIO_PROCESS, static_cast<id_t>(getpid())) + kLower;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), nice);
}

}  // namespace insonate
