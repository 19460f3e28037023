#pragma once

#include <functional>

namespace insonate::ui {

/// Runs `work` on its own thread, for which the window does not wait; objects that `work` owns are destroyed on that
/// thread. waitForJobs() waits for all these threads at the end of the program.
void runInBackground(std::function<void()> work);

}  // namespace insonate::ui
