#pragma once

#include <insonate/haptics/ServoThread.h>

#include <cstddef>
#include <cstdint>

namespace insonate::haptics {

std::int64_t monotonic_ns();
/// Sleeps until `time_ns` of CLOCK_MONOTONIC; returns at once if that time has passed.
void sleepUntil(std::int64_t time_ns);
/// Requests real-time scheduling (SCHED_FIFO) for this thread, and locks its stack and `bytes` from `memory` in RAM.
/// Only memory that the force loop uses is locked: the system's limit is small, and a CT would exceed it.
RealTimeRights askForRealTime(const void* memory, std::size_t bytes);

}  // namespace insonate::haptics
