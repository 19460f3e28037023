#pragma once

#include <QWidget>

class QPushButton;

namespace insonate::ui {
class TaskBar;
}

namespace insonate::prepare {

class PathStep;
struct PrepareModel;

/// The last step of preparing a case: publishes the saved case, if it is fit for training. Trainees get this version
/// until another version is published.
class PublishStep : public QWidget {
 public:
  /// `step`: its mark shows the published version.
  PublishStep(PrepareModel& shared, ui::TaskBar& tasks, PathStep& step);

 private:
  QString obstacle() const;
  void publish();
  void refresh();
  void readVersions();

  PrepareModel& shared_;
  ui::TaskBar& tasks_;
  PathStep& step_;
  QPushButton* publish_;
  int published_ = 0;  ///< number of the published version; 0: none
  bool isLatest_ = false;
  bool wasUnsaved_ = false;
};

}  // namespace insonate::prepare
