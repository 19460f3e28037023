#pragma once

#include <insonate/bench/SegmentationBench.h>
#include <insonate/core/Progress.h>

#include <functional>
#include <optional>
#include <string>

namespace insonate::bench {

/// Measures the times of segmentation tasks one after the other, and adds a row for each to `bench`.
class TaskTimer {
 public:
  struct Task {
    std::string name;
    double voxels = 0;
    std::optional<double> target_ms;
  };

  /// `bench` and `progress` must outlive the timer.
  TaskTimer(SegmentationBench& bench, const Progress& progress) : bench_(bench), progress_(progress) {}

  void time(const Task& task, int repeats, const std::function<void(const Progress&)>& work);

 private:
  SegmentationBench& bench_;
  const Progress& progress_;
};

/// Resets the peak memory of the process. peakMemory_bytes() returns the peak since then; empty if the system does not
/// report it.
void forgetPeakMemory();
std::optional<double> peakMemory_bytes();

/// Returns a sentence on the number of threads, and on the load of the computer by other programs.
std::string machineNote();

}  // namespace insonate::bench
