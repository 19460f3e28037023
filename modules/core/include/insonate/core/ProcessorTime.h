#pragma once

#include <ctime>

namespace insonate {

namespace detail {
inline double processorTime_ms(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}
}  // namespace detail

/// Returns the processor time that this thread has used, ms.
inline double threadTime_ms() {
  return detail::processorTime_ms(CLOCK_THREAD_CPUTIME_ID);
}

/// Returns the processor time that all threads of this process together have used, ms.
inline double processTime_ms() {
  return detail::processorTime_ms(CLOCK_PROCESS_CPUTIME_ID);
}

}  // namespace insonate
