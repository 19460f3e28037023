#pragma once

#include <insonate/prepare/PrepareBenchmark.h>
#include <insonate/segmentation/LabelStep.h>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <array>
#include <functional>
#include <vector>

namespace insonate::prepare {

class CaseViews;
struct PrepareModel;
class ToolSession;

/// Repeats an author's actions, and times each from the input to the painted views.
class LabelingMeasure : public QObject {
 public:
  /// `done` is called once, on the window's thread.
  LabelingMeasure(PrepareModel& shared, ToolSession& tools, CaseViews& views, int repeats,
                  std::function<void(std::vector<LabelingTime>)> done);

 private:
  /// A result of a task that becomes visible, with the time that each repetition took to show it.
  struct Sight {
    QString name;
    std::function<bool()> there;
    std::vector<double> took_ms{};
  };
  /// Pause between two tasks; longer than the time that surfaces and check take after an edit.
  static constexpr double kRest_ms = 1000;
  struct Task {
    int repeats = 1;
    std::function<void()> takeUp;  ///< preparation before the first repetition, not timed; may be empty
    std::function<void(int)> act;
    std::vector<Sight> sights;
    std::function<void()> putBack{};  ///< called after each repetition, not timed
    double rest_ms = kRest_ms;        ///< pause before each repetition
    double pause_ms = 0, work_ms = 0;
  };
  void addViewTasks(int repeats);
  void addToolTasks(int repeats);
  /// Returns the task of running a tool that writes labels.
  Task tool(const QString& name, const LabelStep& step, int repeats);

  void look();
  void begin();
  void endTask();
  void remember();
  bool slicesPainted() const;
  bool scenePainted() const;

  PrepareModel& shared_;
  ToolSession& tools_;
  CaseViews& views_;
  std::function<void(std::vector<LabelingTime>)> done_;
  std::vector<Task> tasks_;
  std::vector<LabelingTime> times_;
  std::size_t task_ = 0;
  int repeat_ = 0;
  bool acting_ = false;
  /// slicesKnow_: the result has reached the slices; sceneKnows_: the result has reached the 3D scene. The views must
  /// then draw the result.
  bool slicesKnow_ = false, sceneKnows_ = false;
  std::array<int, 4> renderings_{};  ///< number of renderings of each view when the result arrived
  double tickWork_ms_ = 0;
  QTimer timer_;
  QElapsedTimer clock_, tick_;
};

}  // namespace insonate::prepare
