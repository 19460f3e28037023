#pragma once

#include <insonate/haptics/ServoThread.h>

#include <cstddef>
#include <cstdint>

namespace insonate::haptics {

std::int64_t monotonic_ns();
/// Sleeps until a time of CLOCK_MONOTONIC; returns at once if the time has passed.
void sleepUntil(std::int64_t time_ns);
/// Requests SCHED_FIFO for this thread, and locks in memory the stack and `bytes` from `memory`. Only memory that the
/// servo uses is locked: the limit is small on most systems, and a CT would exceed it.
RealTimeRights askForRealTime(const void* memory, std::size_t bytes);

}  // namespace insonate::haptics
