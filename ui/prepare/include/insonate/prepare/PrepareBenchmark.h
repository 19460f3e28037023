#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <vector>

namespace insonate::prepare {

class CaseViews;
class LabelingMeasure;
struct PrepareModel;
class ToolSession;

/// Time from an action of the author until its result is on the screen.
struct LabelingTime {
  QString name;  ///< name of the action and, if parts of the views are timed separately, of the part
  double median_ms = 0, longest_ms = 0;
  /// Longest GUI stall during the action, i.e. the longest time in which the window's thread did not process events.
  /// pause_ms: elapsed time; work_ms: processor time of the window's thread, which other programs on the computer do
  /// not affect.
  double pause_ms = 0, work_ms = 0;
};

/// Measures the speed of a Prepare workspace. May be used only on the window's thread.
class PrepareBenchmark final {
 public:
  /// All arguments must outlive this object.
  PrepareBenchmark(PrepareModel& model, ToolSession& tools, CaseViews& views);
  ~PrepareBenchmark();

  /// Measures how fast the open case can be viewed and labeled: repeats each action `repeats` times while the workspace
  /// is shown. Undoes the results of all tools except the brush. When the measurement is complete, `done` is called on
  /// the window's thread, unless the workspace is deleted first.
  void measureLabeling(int repeats, std::function<void(std::vector<LabelingTime>)> done);

 private:
  PrepareModel& model_;
  ToolSession& tools_;
  CaseViews& views_;
  std::unique_ptr<LabelingMeasure> labeling_;
};

}  // namespace insonate::prepare
