#pragma once

#include <insonate/prepare/LabellingTime.h>
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

/// Does what an author does, again and again, and times it from the hand to the painted views.
class LabellingMeasure : public QObject {
 public:
  /// `done` is called once, on the window's thread.
  LabellingMeasure(PrepareModel& shared, ToolSession& tools, CaseViews& views, int repeats,
                   std::function<void(std::vector<LabellingTime>)> done);

 private:
  /// Visible results of a task, and the time of each.
  struct Sight {
    QString name;
    std::function<bool()> there;
    std::vector<double> took_ms{};
  };
  /// Pause between two tasks: longer than surfaces and check take after an edit.
  static constexpr double kRest_ms = 1000;
  struct Task {
    int repeats = 1;
    std::function<void()> takeUp;  ///< once before, not timed; may be empty
    std::function<void(int)> act;
    std::vector<Sight> sights;
    std::function<void()> putBack{};  ///< after each, not timed
    double rest_ms = kRest_ms;        ///< before each
    double pause_ms = 0, work_ms = 0;
  };
  void addViewTasks(int repeats);
  void addToolTasks(int repeats);
  /// A tool that writes.
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
  std::function<void(std::vector<LabellingTime>)> done_;
  std::vector<Task> tasks_;
  std::vector<LabellingTime> times_;
  std::size_t task_ = 0;
  int repeat_ = 0;
  bool acting_ = false;
  /// The result has arrived in the slices and in 3D: now the views have to show it.
  bool slicesKnow_ = false, sceneKnows_ = false;
  std::array<int, 4> renderings_{};  ///< of each view, when it came
  double tickWork_ms_ = 0;
  QTimer timer_;
  QElapsedTimer clock_, tick_;
};

}  // namespace insonate::prepare
