#pragma once

#include <functional>

namespace insonate::ui {

/// Does `work` on a thread of its own that the window does not wait for; what the work holds goes with it, there.
/// waitForJobs() waits for all of them at the end of the program.
void runInBackground(std::function<void()> work);

}  // namespace insonate::ui
