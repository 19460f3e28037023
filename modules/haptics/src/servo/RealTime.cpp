#include "servo/RealTime.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstring>
#include <ctime>

namespace insonate::haptics {
namespace {

/// Below the priorities of the kernel's own work, above those of sound servers.
constexpr int kPriority = 80;
constexpr std::size_t kStack_bytes = 64 * 1024;

bool lockStack() {
  // Touched first, so that its pages are mapped.
  volatile char stack[kStack_bytes];
  for (std::size_t i = 0; i < sizeof stack; i += 1024) stack[i] = 0;
  return mlock(const_cast<const char*>(stack), sizeof stack) == 0;
}

}  // namespace

std::int64_t monotonic_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

void sleepUntil(std::int64_t time_ns) {
  const timespec until{time_ns / 1'000'000'000, time_ns % 1'000'000'000};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

RealTimeRights askForRealTime(const void* memory, std::size_t bytes) {
  RealTimeRights rights;
  sched_param wanted{};
  wanted.sched_priority = kPriority;
  const int refused = pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted);
  rights.priority = refused == 0;
  rights.locked = mlock(memory, bytes) == 0 && lockStack();
  if (rights.priority && rights.locked) {
    rights.sentence = "The servo runs with real-time priority and locked memory.";
    return rights;
  }
  if (!rights.priority)
    rights.sentence = std::string("The servo runs without real-time priority (") + std::strerror(refused) +
                      "): forces may stutter while the computer is busy. Give this user the permission: add a line "
                      "\"USER - rtprio 80\" in /etc/security/limits.d, then log in again.";
  if (!rights.locked) {
    if (!rights.sentence.empty()) rights.sentence += " ";
    rights.sentence +=
        "The memory of the servo is not locked: raise the limit \"memlock\" in /etc/security/limits.d to 1024 or more.";
  }
  return rights;
}

}  // namespace insonate::haptics
