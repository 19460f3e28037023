#include "JobThreads.h"

#include <insonate/ui/TaskBar.h>

#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

namespace insonate::ui {
namespace {

/// Counts the running threads, so that the end of the program can wait for them.
struct Threads {
  std::mutex mutex;
  std::condition_variable changed;
  int running = 0;
};

Threads& threads() {
  static Threads all;
  return all;
}

}  // namespace

void runInBackground(std::function<void()> work) {
  {
    const std::lock_guard lock(threads().mutex);
    ++threads().running;
  }
  std::thread([work = std::move(work)]() mutable {
    work();
    // The work's data must be released before the program ends.
    work = nullptr;
    const std::lock_guard lock(threads().mutex);
    --threads().running;
    threads().changed.notify_all();
  }).detach();
}

bool waitForJobs(std::chrono::milliseconds longest) {
  Threads& all = threads();
  std::unique_lock lock(all.mutex);
  return all.changed.wait_for(lock, longest, [&all] { return all.running == 0; });
}

}  // namespace insonate::ui
