#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <vector>

namespace insonate::prepare {

class CaseViews;
class LabellingMeasure;
struct PrepareModel;
class ToolSession;

/// Elapsed time from an author's action until its result is on the screen.
struct LabellingTime {
  QString name;  ///< name of the action and, if parts of the views are timed separately, of the part
  double median_ms = 0, longest_ms = 0;
  /// Longest time during the action in which the window's thread did not process events: elapsed, and in the thread's
  /// own processor time, which other programs on the computer do not affect.
  double pause_ms = 0, work_ms = 0;
};

/// Measures the speed of a Prepare workspace. For the window's thread.
class PrepareBenchmark final {
 public:
  /// All arguments must outlive this object.
  PrepareBenchmark(PrepareModel& model, ToolSession& tools, CaseViews& views);
  ~PrepareBenchmark();

  /// Measures how fast the open case can be viewed and labeled: each action is repeated `repeats` times while the
  /// workspace is shown. Results of all tools except the brush are undone. Calls `done` later on the window's thread,
  /// unless the workspace is deleted first.
  void measureLabelling(int repeats, std::function<void(std::vector<LabellingTime>)> done);

 private:
  PrepareModel& model_;
  ToolSession& tools_;
  CaseViews& views_;
  std::unique_ptr<LabellingMeasure> labelling_;
};

}  // namespace insonate::prepare
