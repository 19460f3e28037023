#pragma once

#include <insonate/bench/SegmentationBench.h>
#include <insonate/core/Progress.h>

#include <functional>
#include <optional>
#include <string>

namespace insonate::bench {

/// Times tasks one after the other and adds a row for each.
class TaskTimer {
 public:
  struct Task {
    std::string name;
    double voxels = 0;
    std::optional<double> bar_ms;
  };

  /// Both must outlive the timer.
  TaskTimer(SegmentationBench& bench, const Progress& progress) : bench_(bench), progress_(progress) {}

  void time(const Task& task, int repeats, const std::function<void(const Progress&)>& work);

 private:
  SegmentationBench& bench_;
  const Progress& progress_;
};

/// Resets the peak memory of the process. peakMemory() returns the peak since then; empty if the system does not
/// report it.
void forgetPeakMemory();
std::optional<double> peakMemory_bytes();

/// Returns a note on the number of threads, and on how busy the machine is with other programs.
std::string machineNote();

}  // namespace insonate::bench
