#include "TaskTimer.h"

#include "report/CellTable.h"

#include <sys/resource.h>
#include <tbb/info.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <vector>

namespace insonate::bench {
namespace {

using Clock = std::chrono::steady_clock;

double sinceMs(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double cpuMs() {
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  const auto ms = [](const timeval& t) { return double(t.tv_sec) * 1e3 + double(t.tv_usec) * 1e-3; };
  return ms(use.ru_utime) + ms(use.ru_stime);
}

}  // namespace

void TaskTimer::time(const Task& task, int repeats, const std::function<void(const Progress&)>& work) {
  SegmentationTimeRow row;
  row.task = task.name, row.voxels = task.voxels, row.target_ms = task.target_ms;
  std::vector<double> ms;
  const double cpuBefore = cpuMs();
  for (int n = 0; n < repeats; ++n) {
    const auto start = Clock::now();
    auto asked = start;
    const auto hear = [&] {
      row.cancelCheckInterval_ms = std::max(row.cancelCheckInterval_ms, sinceMs(asked));
      asked = Clock::now();
    };
    work([&](std::string_view doing, double fraction) {
      hear();
      return report(progress_, doing, fraction);
    });
    hear();
    ms.push_back(sinceMs(start));
  }
  row.cpu_ms = (cpuMs() - cpuBefore) / repeats;
  std::ranges::sort(ms);
  row.median_ms = ms[ms.size() / 2], row.max_ms = ms.back();
  bench_.times.push_back(row);
}

void forgetPeakMemory() {
  std::ofstream("/proc/self/clear_refs") << "5";
}

std::optional<double> peakMemory_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kB = 0; word == "VmHWM:" && status >> kB) return kB * 1024;
  return std::nullopt;
}

std::string machineNote() {
  double load = -1;
  if (getloadavg(&load, 1) != 1) load = -1;
  return std::to_string(tbb::info::default_concurrency()) + " threads on a machine whose load was " + fixed(load, 1) +
         " at the end: waiting for others counts in times, not in processor time.";
}

}  // namespace insonate::bench
