#pragma once

#include <sys/resource.h>
#include <unistd.h>

namespace insonate {

/// From here on, this thread and those it starts come behind the window's thread and behind images that somebody
/// waits for, but not so far that they could not end when told to. There is no way back. What a thread hands to TBB's
/// workers has their priority: an arena of one thread keeps it here. setpriority(2): on Linux, of a thread.
inline void lowerThreadPriority() {
  constexpr int kNice = 10;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);
}

}  // namespace insonate
