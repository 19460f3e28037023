#pragma once

#include <insonate/core/Progress.h>
#include <insonate/simulator/SegmentationBench.h>

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

  /// Both are to outlive it.
  TaskTimer(SegmentationBench& bench, const Progress& progress) : bench_(bench), progress_(progress) {}

  void time(const Task& task, int repeats, const std::function<void(const Progress&)>& work);

 private:
  SegmentationBench& bench_;
  const Progress& progress_;
};

/// What the process has held at most since forgetPeakMemory(); none where the system does not tell.
void forgetPeakMemory();
std::optional<double> peakMemory_bytes();

/// Threads, and how busy the machine is beside this program.
std::string machineNote();

}  // namespace insonate::bench
