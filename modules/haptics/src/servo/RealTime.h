#pragma once

#include <insonate/haptics/ServoThread.h>

#include <cstddef>
#include <cstdint>

namespace insonate::haptics {

std::int64_t monotonic_ns();
/// Sleeps until CLOCK_MONOTONIC says so; at once where that has passed.
void sleepUntil(std::int64_t time_ns);
/// Asks for SCHED_FIFO for this thread, and that `bytes` from `memory` and its stack stay in memory. Only what the
/// servo touches is locked: the limit is small on most systems, and a CT does not fit below it.
RealTimeRights askForRealTime(const void* memory, std::size_t bytes);

}  // namespace insonate::haptics
